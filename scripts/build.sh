#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Configures and builds a preset, or only TARGETs of it: build.sh [release|debug|asan|tsan [TARGET...]]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=${1:-release}
cmake --preset "$preset" -DEPCC_BUILD_TESTS=ON -DEPCC_BUILD_TOOLS=ON
shift || true
cmake --build --preset "$preset" ${1:+--target "$@"}
