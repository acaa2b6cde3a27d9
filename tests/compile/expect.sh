#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# expect.sh FILE COMPILER [FLAGS...]: compiles FILE and compares with what its `// expect: SENTENCE` lines promise:
#   // expect: ok            it must compile without a warning
#   // expect: SENTENCE      it must not compile, and SENTENCE must stand in what the compiler says (one line per sentence)
# SENTENCE is matched literally. `// flags: -DX` adds flags.
set -u
file=$1
shift
mapfile -t sentences < <(sed -n 's|^// expect: ||p' "$file")
((${#sentences[@]} > 0)) || { echo "$file has no line '// expect: ...'"; exit 1; }
read -r -a flags < <(sed -n 's|^// flags: ||p' "$file"; echo)
said=$("$@" ${flags[@]+"${flags[@]}"} -fsyntax-only "$file" 2>&1)
status=$?
if [[ ${sentences[0]} == ok ]]; then
  ((status == 0)) && [[ -z $said ]] && exit 0
  echo "must compile without a warning, but:"
  echo "$said" | head -60
  exit 1
fi
if ((status == 0)); then
  echo "compiles, but must be refused with: ${sentences[*]}"
  exit 1
fi
for sentence in "${sentences[@]}"; do
  if ! grep -q -F -- "$sentence" <<<"$said"; then
    echo "is refused, but without the sentence: $sentence"
    echo "$said" | head -60
    exit 1
  fi
done
echo "refused as promised, in $(wc -l <<<"$said") lines"
