#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# instantiations.sh CLANG FILE EXPECTED [FLAGS...]: how many of bolide's templates does FILE instantiate? The count does not depend on the machine;
# more than 3 % above EXPECTED fails (look for the cause, or raise EXPECTED and say why), more than 10 % below asks for a new EXPECTED.
set -u
clang=$1 file=$2 expected=$3
shift 3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$clang" "$@" -ftime-trace -ftime-trace-granularity=0 -c "$file" -o "$folder/unit.o" || exit 1
count=$(grep -o '"name":"Instantiate[A-Za-z]*","args":{"detail":"bolide::' "$folder/unit.json" | wc -l)
echo "$(basename "$file"): $count instantiations of templates of bolide, $expected expected"
((count > 0)) || { echo "none counted: is this clang's trace another?"; exit 1; }
((count * 100 <= expected * 103)) || { echo "more than 3 % too many"; exit 1; }
((count * 100 >= expected * 90)) || { echo "more than 10 % fewer: lower the expected number"; exit 1; }
