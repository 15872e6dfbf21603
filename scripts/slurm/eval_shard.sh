#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# One task of a Slurm job array: one shard of an epcc_eval run. Started by submit.sh; see there.
#SBATCH --requeue
#SBATCH --open-mode=append
set -euo pipefail

# The arguments are OUT, the number of shards and the program, then data sets and options of epcc_eval.
out=$1 shards=$2 program=$3
shift 3

# --resume starts the shard, and after a requeue goes on with it; a task that fails for a passing reason (a file server
# away for a moment) is worth two more tries. Wrong usage and --strict's verdict are not.
for try in 1 2 3; do
  code=0
  "$program" "$@" --out "$out/shards/$SLURM_ARRAY_TASK_ID" --shard "$SLURM_ARRAY_TASK_ID/$shards" --resume \
    --jobs "${SLURM_CPUS_PER_TASK:-1}" >/dev/null || code=$?
  if ((code == 0 || code == 2 || code == 3)); then exit "$code"; fi
  if ((try < 3)); then sleep $((10 * try)); fi
done
exit "$code"
