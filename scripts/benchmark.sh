#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Renews the tables of docs/reference/benchmark.md, in less than ten minutes on a quiet machine:
# benchmark.sh [--frames DIR] [...]
# Options go to epcc_bench. What it prints is left in results/benchmark.txt, all numbers in results/benchmark.json.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mkdir -p results
scripts/prepare.sh epcc_bench instruction_count
# Repetitions in turn: a busy moment spoils one of each case, not all of one.
build/release/bin/epcc_bench --benchmark_min_time=0.1 --benchmark_repetitions=3 \
  --benchmark_enable_random_interleaving=true --benchmark_out=results/benchmark.json --benchmark_out_format=json "$@" |
  tee results/benchmark.txt
scripts/benchmark_tables.py results/benchmark.json results/benchmark.txt docs/reference/benchmark.md \
  "$(build/release/bin/instruction_count versions)"
