#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The last job of an epcc_eval run on a cluster: joins the shards. Started by submit.sh.
#SBATCH --requeue
#SBATCH --open-mode=append
set -euo pipefail

# The arguments are OUT, the number of shards and the program.
out=$1 shards=$2 program=$3
folders=()
for ((i = 1; i <= shards; ++i)); do folders+=("$out/shards/$i"); done
exec "$program" merge "${folders[@]}" --out "$out"
