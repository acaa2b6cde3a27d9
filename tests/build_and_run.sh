#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# build_and_run.sh CMAKE BUILD_FOLDER TARGET PROGRAM: builds a test program that the default build leaves out, and runs it.
set -u
said=$("$1" --build "$2" --target "$3" 2>&1) || { echo "$said"; exit 1; }
exec "$4"
