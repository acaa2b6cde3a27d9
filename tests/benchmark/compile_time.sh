#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# compile_time.sh [OUT.csv] [COMPILER...]: what a composition costs to compile: CPU seconds (compiler and assembler) and peak memory of a unit that has one solver
# with the paper's material, and of what it is made of. Default: compile_time.csv, g++ and clang++ where they are. Writes the CSV file and prints the table of
# docs/performance.md. Each unit is compiled once, as examples are built (-O3 -march=native); tests/budget/budget.cpp does the measuring.
set -eu
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
out=${1:-compile_time.csv}
shift || true
compilers=("$@")
((${#compilers[@]})) || for c in g++ clang++; do command -v "$c" >/dev/null && compilers+=("$c"); done
eigen=$(pkg-config --cflags-only-I eigen3 2>/dev/null | sed 's/^-I//; s/ *$//')
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# name | space, dimension | shape | transfer | scheme | precision
compositions=(
  "linear FLIP USF double|axisymmetric|2|linear|flip|usf|double"
  "linear FLIP MUSL double|axisymmetric|2|linear|flip|musl|double"
  "B-spline FLIP USF double|axisymmetric|2|quadratic_bspline|flip|usf|double"
  "B-spline FLIP MUSL double|axisymmetric|2|quadratic_bspline|flip|musl|double"
  "B-spline FLIP USL double|axisymmetric|2|quadratic_bspline|flip|usl|double"
  "B-spline APIC USF double|axisymmetric|2|quadratic_bspline|apic|usf|double"
  "B-spline APIC MUSL double|axisymmetric|2|quadratic_bspline|apic|musl|double"
  "B-spline XPIC(2) USF double|axisymmetric|2|quadratic_bspline|xpic<2>|usf|double"
  "cubic APIC USF double|axisymmetric|2|cubic_bspline|apic|usf|double"
  "GIMP FLIP USF double|axisymmetric|2|gimp|flip|usf|double"
  "linear FLIP USF float|axisymmetric|2|linear|flip|usf|float"
  "B-spline APIC USF float|axisymmetric|2|quadratic_bspline|apic|usf|float"
  "1-D linear FLIP USF double|planar_1d|1|linear|flip|usf|double"
  "3-D linear FLIP USF double|cartesian_3d|3|linear|flip|usf|double"
  "3-D B-spline APIC USF double|cartesian_3d|3|quadratic_bspline|apic|usf|double"
)

headers() { # space, shape
  for h in core/algebra eos/cold/cai_ye eos/cold/tabulated eos/grover eos/phase/mixed eos/state failure/tension_or_melt "shape/$2" solver/solver "space/$1" \
    strength/johnson_cook; do
    echo "#include \"bolide/$h.hpp\""
  done
}
material='using namespace bolide;
auto metal() { return material{eos::grover{cold::tabulated{cold::cai_ye{}}, phase::mixed{}}, strength::johnson_cook{}, failure::tension_or_melt{}}; }'
mkdir "$folder/units"
{ echo '#include <Eigen/Core>'; echo 'void f() {}'; } >"$folder/units/00.cpp"
{ headers axisymmetric linear; echo 'void f() {}'; } >"$folder/units/01.cpp"
{ headers axisymmetric linear; echo "$material"; } >"$folder/units/02.cpp"
names=("Eigen/Core alone" "all headers of one" "a material besides")
for c in "${compositions[@]}"; do
  IFS='|' read -r name space dim shape transfer scheme precision <<<"$c"
  file=$(printf '%s/units/%02d.cpp' "$folder" ${#names[@]})
  names+=("$name")
  {
    headers "$space" "$shape"
    echo "$material"
    cat <<UNIT
void f() {
  using point = vec<double, $dim>;
  const body block{"block", box{point(point::Constant(0)), point(point::Constant(1e-3))}, metal(), 5e-5, initial_state{2785, 0}};
  solver sim{space::$space{}, grid::sparse{1e-4}, shape::$shape{}, transfer::$transfer{}, scheme::$scheme{}, controls<$precision>{}, block};
  sim.run(1e-6);
}
UNIT
  } >"$file"
done

"${compilers[0]}" -std=c++20 -O1 "$root/tests/budget/budget.cpp" -o "$folder/budget"
echo "compiler,composition,cpu_seconds,peak_megabytes" >"$out"
for compiler in "${compilers[@]}"; do
  {
    echo '['
    for file in "$folder"/units/*.cpp; do
      echo '{'
      echo "\"directory\": \"$folder\","
      echo "\"command\": \"$compiler -std=c++20 -O3 -march=native -fno-math-errno -fno-trapping-math -fopenmp -DNDEBUG -Wno-psabi -I$root/include -isystem ${eigen:-/usr/include/eigen3} -c $file\","
      echo "\"file\": \"$file\""
      echo '},'
    done
    echo ']'
  } >"$folder/commands.json"
  version=$("$compiler" --version | head -1 | sed 's/,/ /g')
  "$folder/budget" "$folder/commands.json" "$folder/units/" 100000 100000 1000000 | while read -r seconds _ megabytes _ file rest; do
    [[ ${file:-} == "$folder"/units/*.cpp ]] || continue
    [[ -z ${rest:-} ]] || { echo "$file: $rest" >&2; exit 1; }
    number=$(basename "$file" .cpp)
    echo "$version,${names[10#$number]},$seconds,$megabytes" >>"$out"
  done
done

# the table: a column of seconds and one of megabytes per compiler
awk -F, 'NR > 1 { if (!($1 in seen)) { seen[$1] = 1; c[++n] = $1 } if (!($2 in row)) { row[$2] = 1; r[++m] = $2 } s[$1, $2] = $3; b[$1, $2] = $4 }
  END {
    printf "| composition |"; for (i = 1; i <= n; ++i) printf " %s, s | MB |", c[i]; printf "\n|---|"; for (i = 1; i <= n; ++i) printf "---|---|"; printf "\n"
    for (k = 1; k <= m; ++k) { printf "| %s |", r[k]; for (i = 1; i <= n; ++i) printf " %.1f | %.0f |", s[c[i], r[k]], b[c[i], r[k]]; printf "\n" }
  }' "$out"
