#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, checks the sources, builds release, runs the tests under the sanitizers, fuzzes, and then
# runs every test; ends with ctest's summary.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

stage() { printf '==== %s (after %d s)\n' "$1" "$SECONDS"; }

stage "Packages"
scripts/install_packages.sh clang-format-14 shellcheck valgrind python3-matplotlib doxygen mandoc \
  g++-aarch64-linux-gnu clang-14 libclang-rt-14-dev
stage "Format, scripts, floors"
scripts/check_format.sh
scripts/check_scripts.sh
scripts/check_floors.sh
stage "Build"
scripts/build.sh release
stage "Kernels compiled for arm64"
scripts/check_arm64.sh
stage "Instructions a frame"
scripts/check_speed.sh || (($? == 77)) # not on every processor
stage "Tests under AddressSanitizer and UndefinedBehaviorSanitizer, programs included"
scripts/sanitize.sh asan
stage "Lines that these tests have run"
scripts/coverage.sh
stage "Tests of all that has threads under ThreadSanitizer"
scripts/sanitize.sh tsan
stage "Fuzzing, 30 s a target"
scripts/fuzz.sh --seed 1 # a change must not fail by chance for what was there before it
stage "Tests"
exec ctest --test-dir build/release --output-on-failure -j "$(nproc)"
