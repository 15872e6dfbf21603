#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# For scripts that need programs: installs what is missing and builds TARGETs of the release preset. What the build says
# is shown only if it fails: prepare.sh TARGET...
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

log=build/prepare.log
mkdir -p build
scripts/install_packages.sh
echo "Building (a few minutes the first time)" >&2
if ! scripts/build.sh release "$@" >"$log" 2>&1; then
  tail -n 30 "$log" >&2
  echo "prepare.sh: the build failed, see $log" >&2
  exit 1
fi
