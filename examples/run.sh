#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# bash examples/run.sh [NAME [ARGS...]]    installs what is missing, builds example NAME for this machine and runs it with ARGS.
# NAME is a folder beside this script (default aluminium_impact). Standard input, standard output and the exit code are the program's;
# what this script, the package manager and the build have to say goes to standard error.
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

list_examples() {
  echo "usage: bash examples/run.sh [NAME [ARGS...]]; examples:" >&2
  local source
  for source in "$here"/*/; do
    compgen -G "$source*.cpp" >/dev/null && echo "  $(basename "$source")" >&2
  done
}

name=${1-aluminium_impact}
(($#)) && shift
if [[ $name == -h || $name == --help ]]; then
  list_examples
  exit 0
fi
if [[ -z $name || $name == */* || $name == .* ]] || ! compgen -G "$here/$name/*.cpp" >/dev/null; then
  echo "bolide: there is no example '$name'" >&2
  list_examples
  exit 2
fi

source "$here/../cmake/packages.sh"
bolide_packages
bolide_build "$name"
exec "$BOLIDE_BUILD/examples/$name" "$@"
