#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# check.sh MODE BUILD_DIR COMPILER WORK_DIR: bolide as a user's project meets it.
#   find_package       installs the build tree's package to a fresh prefix; a consumer finds it there, builds and runs
#   components         the same with COMPONENTS gsl png hdf5, the consumer uses all
#   wrong_component    a component that does not exist is refused with a sentence
#   wrong_version      a version that is not this one is refused
#   add_subdirectory   the source tree as a subdirectory: targets are there, tests, examples and warning flags are not
set -eu
mode=$1 build=$2 compiler=$3 work=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source_dir=$(cd "$here/../.." && pwd)
rm -rf "$work"
mkdir -p "$work"
configure() { cmake -G Ninja -S "$here/$1" -B "$work/build" -DCMAKE_CXX_COMPILER="$compiler" "${@:2}"; }
build_and_run() {
  cmake --build "$work/build"
  "$work/build/consumer"
}
refused_with() {
  local said
  if said=$(configure installed "${@:2}" 2>&1); then
    echo "must be refused: $1"
    exit 1
  fi
  grep -q -F "$1" <<<"$(tr -s ' \n' ' ' <<<"$said")" || { echo "refused, but not with '$1':"; echo "$said"; exit 1; }
}

[[ $mode == add_subdirectory ]] || cmake --install "$build" --prefix "$work/prefix" >/dev/null
installed=(-DCMAKE_PREFIX_PATH="$work/prefix")
case $mode in
  find_package) configure installed "${installed[@]}" && build_and_run ;;
  components) configure installed "${installed[@]}" -DCONSUMER_COMPONENTS="gsl;png;hdf5" && build_and_run ;;
  wrong_component) refused_with "bolide has no component 'netcdf'" "${installed[@]}" -DCONSUMER_COMPONENTS=netcdf ;;
  wrong_version) refused_with 'compatible with requested version "99.0"' "${installed[@]}" -DCONSUMER_VERSION=99.0 ;;
  add_subdirectory)
    configure subdirectory -DBOLIDE_SOURCE="$source_dir" && build_and_run
    [[ ! -e $work/build/bolide/tests && ! -e $work/build/bolide/examples ]] || { echo "tests or examples came along"; exit 1; }
    if grep -E 'Wconversion|Wpedantic|Werror|march=native' "$work/build/build.ninja"; then echo "flags ride on the interface target"; exit 1; fi
    ;;
  *) echo "unknown mode $mode"; exit 2 ;;
esac
