#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Shows that check_floors.sh lets a tree in order pass and notices each kind of include that it forbids.
set -euo pipefail

check=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/scripts/check_floors.sh
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT

# has FILE INCLUDED: FILE of the tree includes that.
has() {
  mkdir -p "$dir/$(dirname "$1")"
  printf '#pragma once\n  #  include %s\n' "$2" >>"$dir/$1"
}

fail() {
  echo "check_floors_test.sh: $1" >&2
  exit 1
}

clean_tree() {
  rm -rf "${dir:?}"/*
  has epcc_segmentation/include/epcc_segmentation/frame.h '<vector>'
  has epcc_segmentation/src/inner/step.h '"epcc_segmentation/frame.h"'
  has epcc_segmentation/src/all.cpp '"inner/step.h"'
  has datasets/support/text.h '<string>'
  has datasets/files/png.h '"datasets/support/text.h"'
  has datasets/sources/folder.h '"epcc_segmentation/frame.h"'
  has datasets/sources/folder.cpp '"datasets/files/png.h"'
  has baselines/method.h '"datasets/files/png.h"'
  has eval/report/table.h '"eval/measures/score.h"'
  has eval/measures/score.h '"baselines/method.h"'
  has eval/pictures/color.h '<string>'
  has tests/epcc_segmentation/step_test.cpp '"inner/step.h"'
  has tests/baselines/method_test.cpp '"eval/measures/score.h"'
  printf '# Data. Arrows between the rooms:\n# sources -> files -> support.\nx()\n' >"$dir/datasets/CMakeLists.txt"
  printf '# Arrows between the rooms: report -> measures; report -> pictures. More.\n' >"$dir/eval/CMakeLists.txt"
}

clean_tree
"$check" "$dir" || fail "a tree in order does not pass"

# refused FILE INCLUDED WORDS: the clean tree with that include is refused in one line that names it.
refused() {
  local line
  clean_tree
  has "$1" "$2"
  if line=$("$check" "$dir" 2>&1); then fail "$1 may include $2"; fi
  [[ $line == "$1:"*"$3"* && $line != *$'\n'* ]] || fail "$1 includes $2: expected '$3', got '$line'"
}

refused epcc_segmentation/src/all.cpp '"datasets/support/text.h"' "a floor above"
refused epcc_segmentation/src/all.cpp '"../../eval/pictures/color.h"' "a floor above"
refused datasets/files/png.h '"baselines/method.h"' "a floor above"
refused datasets/files/png.h '"eval/pictures/color.h"' "a floor above"
refused baselines/method.h '<eval/pictures/color.h>' "a floor above"
refused eval/pictures/color.h '"tests/baselines/method_test.cpp"' "a floor above"
refused datasets/support/text.h '"datasets/files/png.h"' "no arrow leads from datasets/support"
refused datasets/files/png.h '"../sources/folder.h"' "no arrow leads from datasets/files"
refused eval/measures/score.h '"eval/report/table.h"' "no arrow leads from eval/measures"
refused eval/measures/score.h '"eval/pictures/color.h"' "no arrow leads from eval/measures"
refused eval/unheard/of.h '"eval/pictures/color.h"' "no arrow leads from eval/unheard"
refused epcc_segmentation/include/epcc_segmentation/frame.h '"inner/step.h"' "a public header"
refused baselines/method.h '"inner/step.h"' "only the core and its tests"
refused baselines/method.h '"epcc_segmentation/src/inner/step.h"' "only the core and its tests"
refused tests/baselines/method_test.cpp '"inner/step.h"' "only the core and its tests"
