#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails if the tests under AddressSanitizer, whose build counts lines, have run less than 95 % of the lines of the core,
# of the readers or of the measures. Counted are those of the last scripts/sanitize.sh asan. Of a kernel, which is
# compiled for several vector units, a line counts as run if it was on one of them. All lines are in build/coverage/.
#   coverage.sh [BUILD]    BUILD: build/asan
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install_packages.sh gcovr
build=${1:-build/asan}
least=95
parts=("core epcc_segmentation/(src|include)/" "readers datasets/" "measures eval/measures/")
out=build/coverage

# Counts are named by the path of their object (cmake/EpccTargets.cmake), with # for /, below the build where ccache
# compiles; they go beside it, where gcov looks for them.
for counts in "$build"/tmp/epcc-lines/*.gcda; do
  object=${counts##*/}
  object=${object//#//}
  [[ $object == /* ]] || object=$build/$object
  if [[ -e $counts ]]; then mv "$counts" "$object"; fi
done
if [[ -z $(find "$build" -name '*.gcda' -print -quit 2>/dev/null) ]]; then
  echo "coverage.sh: no lines were counted: run scripts/sanitize.sh asan" >&2
  exit 2
fi
mkdir -p "$out"
# Threads count without waiting for each other: some branches end below zero, which gcovr takes for an error.
if ! gcovr --root . --gcov-ignore-parse-errors --filter "(epcc_segmentation|datasets|eval/measures)/" \
  --json "$out/lines.json" -j "$(nproc)" "$build" 2>"$out/gcovr.log"; then
  tail -n 20 "$out/gcovr.log" >&2
  exit 1
fi
failed=0
for part in "${parts[@]}"; do
  name=${part%% *}
  gcovr --root . --add-tracefile "$out/lines.json" --filter "${part#* }" --txt "$out/$name.txt" --print-summary \
    --fail-under-line "$least" >"$out/$name.summary" 2>"$out/$name.problem" || failed=1
  echo "$name: $(head -n 1 "$out/$name.summary")"
done
if ((failed)); then
  echo "coverage.sh: that is less than $least %; the lines that no test runs are in $out/*.txt" >&2
  exit 1
fi
