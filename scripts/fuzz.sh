#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the fuzzing targets of tests/fuzz with clang-14, writes their seeds and runs them, two at a time, each for 30
# seconds unless told; prints a line for each: fuzz.sh [--seconds N | --runs N] [--seed N] [--jobs N] [TARGET...]
# Exit code 1 if one of them ends with a finding: the input that led to it is kept, and named. What was learnt, the
# corpus, is kept in build/fuzz/corpus from run to run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

limit=-max_total_time=30
jobs=2
seed=0 # another one each time
# Freed memory is not kept for long: fresh memory takes half of a reader's time.
export ASAN_OPTIONS=quarantine_size_mb=4:thread_local_quarantine_size_kb=64
export LSAN_OPTIONS=suppressions=$PWD/cmake/lsan.supp:print_suppressions=0
targets=()
while (($#)); do
  case $1 in
    --seconds) limit=-max_total_time=${2:?fuzz.sh: --seconds N}; shift 2 ;;
    --runs) limit=-runs=${2:?fuzz.sh: --runs N}; shift 2 ;;
    --seed) seed=${2:?fuzz.sh: --seed N}; shift 2 ;;
    --jobs) jobs=${2:?fuzz.sh: --jobs N}; shift 2 ;;
    -*) echo "fuzz.sh: unknown option $1" >&2; exit 2 ;;
    *) targets+=("$1"); shift ;;
  esac
done

cmake --preset fuzz >/dev/null
build=build/fuzz
programs=("${targets[@]/#/fuzz_}")
cmake --build --preset fuzz --target "${programs[@]:-fuzzers}"
if ((!${#targets[@]})); then
  for program in "$build"/bin/fuzz_*; do targets+=("${program##*/fuzz_}"); done
fi

dictionary_of() {
  case $1 in
    depth_png | label_png) echo png ;;
    carmen_log | scan_table) echo laser ;;
    *) echo "$1" ;;
  esac
}

# What libFuzzer has printed last, of "#123 DONE cov: 45 ft: 67 corp: 8/9b ... exec/s: 10".
value_of() { grep -oE "$1 +[0-9]+" "$2" | tail -n 1 | grep -oE '[0-9]+$' || echo 0; }

run_target() {
  local target=$1 program=$build/bin/fuzz_$1 corpus=$build/corpus/$1 found=$build/findings/$1 log=$build/logs/$1.log
  mkdir -p "$corpus" "$found" "$build/logs"
  rm -rf "$build/seeds/$target"
  "$program" --write-seeds "$build/seeds/$target"
  # Entropic scheduling takes most of the time of a target with thousands of edges.
  local options=("$limit" "-seed=$seed" -rss_limit_mb=2048 -malloc_limit_mb=1024 -timeout=10 -max_len=4096 -entropic=0
    -print_final_stats=1 "-artifact_prefix=$found/")
  local dictionary
  dictionary=tests/fuzz/dictionaries/$(dictionary_of "$target").dict
  if [[ -f $dictionary ]]; then options+=("-dict=$dictionary"); fi
  local code=0 verdict="no finding"
  "$program" "${options[@]}" "$corpus" "$build/seeds/$target" >"$log" 2>&1 || code=$?
  if ((code != 0)); then verdict="FINDING: $(sed -n 's/.*Test unit written to //p' "$log" | tail -n 1), see $log"; fi
  printf '%-12s %10d executions  %6d a second  %6d edges  %s\n' "$target" \
    "$(value_of stat::number_of_executed_units: "$log")" "$(value_of stat::average_exec_per_sec: "$log")" \
    "$(value_of cov: "$log")" "$verdict"
  # Where nobody can look at the files, in CI, these lines are all there is.
  if ((code != 0)); then
    grep -E 'runtime error|^what must hold|^ *#[0-9]+ |ERROR|SUMMARY|^Base64' "$log" | head -n 40 | sed "s/^/$target: /"
  fi
  return "$code"
}

code=0
for target in "${targets[@]}"; do
  while (($(jobs -rp | wc -l) >= jobs)); do wait -n || code=1; done
  run_target "$target" &
done
while [[ -n $(jobs -p) ]]; do wait -n || code=1; done
exit "$code"
