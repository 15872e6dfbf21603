#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails if a C++ source is not formatted as .clang-format has it. Versions of clang-format differ in what they write: the
# project's is 14, Debian 12's. Exit code 77 where it is not installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

version=14
program=$(command -v "clang-format-$version" || command -v clang-format) || program=''
if [[ -z $program || ! $("$program" --version) =~ \ version\ $version\. ]]; then
  echo "check_format.sh: clang-format $version is not installed (Debian: clang-format-$version)" >&2
  exit 77
fi
scripts/source_files.sh . .cpp .h .hpp | xargs -d '\n' "$program" --dry-run --Werror
