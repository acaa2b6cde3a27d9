#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# check.sh INCLUDE_DIR COMPILER [FLAGS...]: every header compiles alone, twice included, without a warning. Two at a time.
# SKIP_ROOMS="gsl png" leaves out rooms whose outside library is not there.
set -u
include=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mapfile -t headers < <(cd "$include" && find bolide -name '*.hpp' | sort)
for room in ${SKIP_ROOMS-}; do
  mapfile -t headers < <(printf '%s\n' "${headers[@]}" | grep -v "^bolide/$room/")
done
((${#headers[@]} > 0)) || { echo "no headers below $include"; exit 1; }

# Compiles every second header, starting with number $1.
half() {
  local i unit
  for ((i = $1; i < ${#headers[@]}; i += 2)); do
    unit=$work/$i.cpp
    printf '#include "%s"\n#include "%s"\n' "${headers[i]}" "${headers[i]}" >"$unit"
    "${command[@]}" "$unit" >"$work/$i.log" 2>&1 || echo "${headers[i]}" >"$work/$i.failed"
  done
}
command=("$@" -I"$include" -fsyntax-only)
half 0 &
half 1
wait

failed=0
for ((i = 0; i < ${#headers[@]}; ++i)); do
  [[ -f $work/$i.failed ]] || continue
  failed=$((failed + 1))
  echo "---- ${headers[i]} does not compile alone:"
  head -40 "$work/$i.log"
done
echo "${#headers[@]} headers with $1, $failed failed"
exit $((failed != 0))
