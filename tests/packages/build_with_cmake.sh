#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds and runs the programs of tests/install_consumer/program with CMake against what is installed:
# build_with_cmake.sh SOURCES BUILD_FOLDER
set -euo pipefail

for component in core geometry pcl; do
  cmake -S "$1" -B "$2/$component" -DEPCC_COMPONENT="$component" -DCMAKE_BUILD_TYPE=Release >/dev/null
  cmake --build "$2/$component" >/dev/null
  "$2/$component/use_$component"
done
