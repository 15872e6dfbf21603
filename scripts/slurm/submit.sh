#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Scores data sets on a Slurm cluster: a job array, one shard a task, and a job that merges them.
#   submit.sh --out DIR --shards N [--throttle K] [--sbatch "OPTIONS"] -- DATASET... [options of epcc_eval]
# DIR must be on a disk that all nodes share; the report is left there, the shards below DIR/shards, the logs in DIR/logs.
# The same line again goes on with a run that was stopped. EPCC_EVAL names the program if it is not in PATH.
set -euo pipefail

usage() {
  echo "submit.sh: $1 (submit.sh --out DIR --shards N [--throttle K] [--sbatch OPTIONS] -- DATASET... [options])" >&2
  exit 2
}

out='' shards='' throttle='' extra=()
while (($#)); do
  case $1 in
    --) shift; break ;;
    --out | --shards | --throttle | --sbatch)
      (($# > 1)) || usage "$1 needs a value"
      case $1 in
        --out) out=$2 ;;
        --shards) shards=$2 ;;
        --throttle) throttle=$2 ;;
        --sbatch) read -ra extra <<<"$2" ;;
      esac
      shift 2 ;;
    *) usage "'$1' is not known; data sets come after --" ;;
  esac
done
[[ -n $out ]] || usage "--out is missing"
[[ $shards =~ ^[1-9][0-9]{0,5}$ ]] || usage "--shards must be a number from 1 on"
[[ -z $throttle || $throttle =~ ^[1-9][0-9]*$ ]] || usage "--throttle must be a number from 1 on"
(($#)) || usage "name at least one DATASET after --"
program=$(command -v "${EPCC_EVAL:-epcc_eval}") || usage "there is no program ${EPCC_EVAL:-epcc_eval}; set EPCC_EVAL"

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$out/logs"
out=$(cd "$out" && pwd)
program=$(realpath "$program")

array=$(sbatch --parsable --job-name=epcc_eval --array="1-$shards${throttle:+%$throttle}" \
  --output="$out/logs/shard_%a.log" "${extra[@]}" "$here/eval_shard.sh" "$out" "$shards" "$program" "$@")
merge=$(sbatch --parsable --job-name=epcc_merge --dependency="afterok:${array%%;*}" --kill-on-invalid-dep=yes \
  --output="$out/logs/merge.log" "${extra[@]}" "$here/eval_merge.sh" "$out" "$shards" "$program")
echo "array ${array%%;*}, merge ${merge%%;*}"
