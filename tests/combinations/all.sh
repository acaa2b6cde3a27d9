#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# all.sh FOLDER COMPILER [FLAGS...]: compiles all.cpp in FOLDER for every space and shape, as many at once as there are processors, and runs each.
set -u
folder=$1
shift
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$folder"
one() {
  local space=$1 shape=$2
  shift 2
  local program=$folder/$space-$shape
  "$@" -DSPACE="$space" -DSHAPE="$shape" "$here/all.cpp" -o "$program" && "$program"
}
export -f one
export folder here
for space in planar_1d plane_strain axisymmetric cartesian_3d; do
  for shape in linear gimp quadratic_bspline cubic_bspline; do printf '%s\n%s\n' "$space" "$shape"; done
done | xargs -n 2 -P "$(nproc)" bash -c 'one "$1" "$2" '"$(printf '%q ' "$@")" _
