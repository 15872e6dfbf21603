#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Prints the paths of the project's files with the given endings, relative to its top, one a line, sorted:
# source_files.sh ROOT ENDING... (for example . .cpp .h). Without git, as in an unpacked archive, all but build folders,
# results and hidden folders count.
set -euo pipefail

cd "$1"
shift
patterns=()
for ending; do patterns+=("*$ending"); done

listed() {
  if [[ $(git rev-parse --show-toplevel 2>/dev/null) == "$(pwd -P)" ]]; then
    git ls-files --cached --others --exclude-standard -- "${patterns[@]}"
  else
    local names=() pattern
    for pattern in "${patterns[@]}"; do names+=(-o -name "$pattern"); done
    find . \( -path './build*' -o -path ./results -o -path './.?*' ! -path ./.ci ! -path './.ci/*' \) -prune \
      -o -type f \( "${names[@]:1}" \) -printf '%P\n'
  fi
}

# Git also lists files that were deleted without telling it.
listed | sort -u | while IFS= read -r file; do
  if [[ -f $file ]]; then printf '%s\n' "$file"; fi
done
