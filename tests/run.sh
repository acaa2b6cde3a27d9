#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# bash tests/run.sh [CTEST ARGS...]    installs what is missing, builds and runs the tests.
# Without arguments: all but those labelled slow (CI runs them while it has time) or exhaustive (a quarter of an hour of compiling).
# With arguments: `ctest --output-on-failure ARGS`, for example
#   bash tests/run.sh -L unit            bash tests/run.sh -R Tillotson            bash tests/run.sh -L slow
# Standard output and the exit code are ctest's; the package manager and the build talk to standard error.
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../cmake/packages.sh"
bolide_packages clang
bolide_optional lammps lmp # tests/validate/lammps_test.cpp
bolide_build all
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc 2>/dev/null || echo 2)}
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive} # tests share the cores: threads that spin would take them from one another
(($#)) || set -- -LE "slow|exhaustive"
exec ctest --test-dir "$BOLIDE_BUILD" --output-on-failure --no-tests=error "$@"
