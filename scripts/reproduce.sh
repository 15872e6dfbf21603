#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds release and prints the comparison table: reproduce.sh [--paper|--default] [...]
# Further options go to epcc_compare, see docs/comparison.md. Tables and Fig. 21 are left in results/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

log=build/reproduce.log
mkdir -p build
scripts/install_packages.sh
echo "Building (a few minutes the first time)" >&2
if ! { cmake --preset release && cmake --build --preset release --target epcc_compare; } >"$log" 2>&1; then
  tail -n 30 "$log" >&2
  echo "reproduce.sh: the build failed, see $log" >&2
  exit 1
fi
exec build/release/bin/epcc_compare "$@"
