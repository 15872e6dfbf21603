#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails if shellcheck finds fault with a shell script. Exit code 77 where it is not installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if ! command -v shellcheck >/dev/null; then
  echo "check_scripts.sh: shellcheck is not installed" >&2
  exit 77
fi
{ scripts/source_files.sh . .sh && echo .ci/run && find cmake/debian/python -type f; } | xargs -d '\n' shellcheck --external-sources
