#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# subbuild.sh SOURCE_DIR BUILD_DIR CMAKE_ARGS...: the unit tests in a build of their own (sanitizers, another compiler). A clean run says so.
set -eu
source_dir=$1 build=$2
shift 2
cmake -G Ninja -S "$source_dir" -B "$build" -DCMAKE_BUILD_TYPE=Release -DBOLIDE_UNIT_TESTS_ONLY=ON -DBOLIDE_EXAMPLES=OFF \
  -DBOLIDE_BENCHMARKS=OFF -DBOLIDE_INSTALL=OFF -DBOLIDE_WERROR=ON "$@"
cmake --build "$build" -j 2
ctest --test-dir "$build" --output-on-failure --no-tests=error -L unit -LE slow -j 2
