#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails if a source file includes what it must not: a floor above its own (epcc_segmentation < datasets < baselines < eval
# < tests), a room of datasets/ or eval/ that no arrow in that folder's CMakeLists.txt leads to, or a header from
# epcc_segmentation/src outside of it and its tests; public headers include none of those either.
#   check_floors.sh [ROOT]
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "${1:-$here/..}"

# "arrows FLOOR: a, b -> c -> d; e -> f" from the comment at the top of a floor's CMakeLists.txt.
arrows() {
  local floor
  for floor in datasets eval; do
    if [[ ! -f $floor/CMakeLists.txt ]]; then continue; fi
    sed -n '/^#/!q; s/^# *//p' "$floor/CMakeLists.txt" | tr '\n' ' ' |
      sed -n "s/.*Arrows between the rooms: *\([^.]*\)\..*/arrows $floor: \1\n/p"
  done
}

mapfile -t files < <("$here/source_files.sh" . .cpp .h .hpp)
includes() { grep -EHn '^[[:space:]]*#[[:space:]]*include[[:space:]]*["<]' "${files[@]}" /dev/null | sed 's/^/include /'; }
{
  arrows
  printf 'file %s\n' "${files[@]}"
  includes
} | awk -f "$here/check_floors.awk"
