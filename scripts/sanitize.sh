#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds and runs the tests that are meant for a sanitizer: asan (memory and undefined behaviour, with assertions), of the
# core, the PCL class, the data sets, the methods, the measures and the programs; tsan (data races), of all that has
# threads: sanitize.sh asan|tsan
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

sanitizer=${1:?sanitize.sh: name asan or tsan}
scripts/build.sh "$sanitizer" "${sanitizer}_tests"
# Lines are counted anew (scripts/coverage.sh): the counts of another build do not fit.
rm -rf "build/$sanitizer/tmp/epcc-lines"
find "build/$sanitizer" -name '*.gcda' -delete
exec ctest --preset "$sanitizer" -L "$sanitizer" -j "$(nproc)"
