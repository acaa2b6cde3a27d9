# SPDX-License-Identifier: MIT
# Sourced by examples/run.sh and tests/run.sh: installs what is missing, configures and builds. Everything here talks to standard
# error and reads nothing from standard input, so that both stay the program's own.
#
#   bolide_packages [clang]           makes sure that compiler, tools and libraries are there
#   bolide_optional PACKAGE COMMAND   installs the package if the command is not on the path; goes on without it where that fails
#   bolide_build TARGET...            configures once, builds the targets; sets BOLIDE_BUILD to the build folder
#
# Environment: BOLIDE_PRESET (default release), BOLIDE_JOBS, BOLIDE_SKIP_PACKAGES=1 (libraries lie where the probe does not look).
# shellcheck shell=bash

bolide_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bolide_configure_again=0

bolide_say() { printf 'bolide: %s\n' "$*" >&2; }
bolide_fail() {
  bolide_say "$*"
  exit 1
}

# Which Debian packages are missing, by what they give: a command on the path or a header that the compiler finds.
bolide_missing() {
  local probe present pair
  command -v g++ >/dev/null || echo g++
  command -v cmake >/dev/null || echo cmake
  command -v ninja >/dev/null || echo ninja-build
  local headers=(libeigen3-dev:Eigen/Core libgsl-dev:gsl/gsl_version.h libpng-dev:png.h libcli11-dev:CLI/CLI.hpp
    nlohmann-json3-dev:nlohmann/json.hpp libhdf5-dev:hdf5.h libgtest-dev:gtest/gtest.h libbenchmark-dev:benchmark/benchmark.h)
  probe=$(for pair in "${headers[@]}"; do printf '#if __has_include(<%s>)\n<present> %s\n#endif\n' "${pair#*:}" "${pair%%:*}"; done)
  present=$(printf '%s\n' "$probe" | g++ -std=c++20 -E -P -x c++ -I/usr/include/eigen3 -I/usr/local/include/eigen3 -I/usr/include/hdf5/serial - 2>/dev/null)
  for pair in "${headers[@]}"; do
    grep -q -F -- "<present> ${pair%%:*}" <<<"$present" || echo "${pair%%:*}"
  done
  if [[ ${1-} == clang ]] && ! command -v clang++ >/dev/null; then echo clang; fi
}

bolide_packages() {
  [[ ${BOLIDE_SKIP_PACKAGES-} == 1 ]] && return
  local missing as_root=()
  mapfile -t missing < <(bolide_missing "$@" </dev/null)
  ((${#missing[@]})) || return 0
  if ! command -v apt-get >/dev/null; then
    if [[ ${missing[*]} == clang ]]; then
      bolide_say "clang++ is not there; the tests that need it are left out"
      return 0
    fi
    bolide_fail "these are missing (Debian's names): ${missing[*]}. This system has no apt-get: install them with its own package" \
      "manager and call again (BOLIDE_SKIP_PACKAGES=1 skips this check)."
  fi
  if ((EUID != 0)); then
    command -v sudo >/dev/null || bolide_fail "these packages are missing and this is neither root nor has it sudo; as root run:" \
      "apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  bolide_say "installing ${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0)
  "${apt[@]}" update </dev/null >&2 || bolide_say "apt-get update failed; going on with the package lists that are there"
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" </dev/null >&2 || bolide_fail "apt-get could not install: ${missing[*]}"
  bolide_configure_again=1
  mapfile -t missing < <(bolide_missing "$@" </dev/null)
  ((${#missing[@]} == 0)) || bolide_fail "still missing after the installation: ${missing[*]}"
}

# Never asks and never fails: who runs the command looks for it.
bolide_optional() {
  local package=$1 command=$2 as_root=()
  [[ ${BOLIDE_SKIP_PACKAGES-} == 1 ]] && return 0
  command -v "$command" >/dev/null && return 0
  if command -v apt-get >/dev/null && { ((EUID == 0)) || command -v sudo >/dev/null; }; then
    ((EUID == 0)) || as_root=(sudo -n)
    bolide_say "installing $package"
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 -o Acquire::Retries=0 -o Acquire::http::Timeout=20)
    local install=("${apt[@]}" install -y --no-install-recommends "$package")
    "${install[@]}" </dev/null >&2 || { "${apt[@]}" update </dev/null >&2 && "${install[@]}" </dev/null >&2; }
  fi
  command -v "$command" >/dev/null || bolide_say "$package ($command) is not there and could not be installed; what needs it is skipped"
}

# One compiler per core, but none without 1.2 GB of memory.
bolide_jobs() {
  local cores memory
  cores=$(nproc 2>/dev/null || echo 2)
  memory=$(awk '/^MemAvailable/ { print int($2 / 1200000) }' /proc/meminfo 2>/dev/null)
  [[ -n $memory ]] || memory=$cores
  ((memory < cores)) && cores=$memory
  ((cores > 0)) || cores=1
  echo "$cores"
}

bolide_build() {
  local preset=${BOLIDE_PRESET:-release}
  BOLIDE_BUILD=$bolide_root/build/$preset
  # A build folder of another checkout (a copied tree) is of no use.
  if [[ -f $BOLIDE_BUILD/CMakeCache.txt ]] && ! grep -q -x -F "CMAKE_HOME_DIRECTORY:INTERNAL=$bolide_root" "$BOLIDE_BUILD/CMakeCache.txt"; then
    bolide_say "$BOLIDE_BUILD belongs to another checkout: building anew"
    rm -rf "$BOLIDE_BUILD"
  fi
  if [[ ! -f $BOLIDE_BUILD/build.ninja ]] || ((bolide_configure_again)); then
    bolide_say "configuring ($preset) in $BOLIDE_BUILD"
    (cd "$bolide_root" && cmake --preset "$preset") </dev/null >&2 || bolide_fail "configuring failed"
  fi
  cmake --build "$BOLIDE_BUILD" -j "${BOLIDE_JOBS:-$(bolide_jobs)}" --target "$@" </dev/null >&2 || bolide_fail "building $* failed"
}
