#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Proves scripts/slurm on this machine: a real one-node Slurm (Debian's packages, started by hand, as root), a job array
# over rendered frames, a node that dies with its tasks, a worker that is killed; the merged report must be that of one
# unsharded run, times aside. Takes about five minutes, two of them the pause that Slurm makes before it starts a requeued
# task, and leaves nothing running.
#   selftest.sh [SHARDS]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

shards=${1:-6}
((EUID == 0)) || { echo "selftest.sh: Slurm's daemons need root" >&2; exit 1; }
scripts/install_packages.sh slurmctld slurmd slurm-client munge
scripts/prepare.sh epcc_eval epcc_scene
bin=$PWD/build/release/bin

dir=$(mktemp -d)
chmod 755 "$dir"
pids=()
cleanup() {
  local pid i
  scancel --quiet --user=root 2>/dev/null || true
  for ((i = 0; i < 100; ++i)); do
    workers >/dev/null 2>&1 || break
    sleep 0.1
  done
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$dir"
}
trap cleanup EXIT

fail() {
  echo "selftest.sh: $1" >&2
  tail -n 15 "$dir"/*.log "$dir"/out/logs/*.log >&2 2>/dev/null || true
  exit 1
}

# until_true WHAT COMMAND...: waits until the command succeeds. The deadline is for a step that hangs: two minutes pass
# before Slurm starts a requeued task, all else takes seconds on a quiet machine.
until_true() {
  local what=$1 end=$((SECONDS + 1800))
  shift
  while ((SECONDS < end)); do
    if "$@" >/dev/null 2>&1; then return 0; fi
    sleep 0.2
  done
  fail "$what: not within half an hour"
}

# free_port FROM: the first port from there on that nothing listens on.
free_port() {
  local port=$1
  while (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; do port=$((port + 1)); done
  echo "$port"
}

start_munge() {
  install -d -o munge -g munge -m 755 "$dir/munge"
  head -c 128 /dev/urandom >"$dir/munge/key"
  chown munge: "$dir/munge/key" && chmod 400 "$dir/munge/key"
  runuser -u munge -- munged --foreground --force --socket="$dir/munge/socket" --key-file="$dir/munge/key" \
    --log-file="$dir/munge/log" --pid-file="$dir/munge/pid" --seed-file="$dir/munge/seed" >"$dir/munged.log" 2>&1 &
  pids+=($!)
  until_true "munge" munge --no-input --socket="$dir/munge/socket"
}

write_config() {
  mkdir -p "$dir/state" "$dir/spool"
  cat >"$dir/slurm.conf" <<CONF
ClusterName=epcc
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$(free_port 16817)
SlurmdPort=$(free_port 17818)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$dir/munge/socket
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
SlurmdTimeout=20
KillWait=5
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
  export SLURM_CONF=$dir/slurm.conf
}

start_slurmd() {
  slurmd -D >>"$dir/slurmd.log" 2>&1 &
  slurmd_pid=$!
  pids+=("$slurmd_pid")
  until_true "the node" node_is_up
}
node_is_up() { [[ $(sinfo -h -o %t) =~ ^(idle|mix|alloc)$ ]]; }

# The report without times.
report() {
  sed '/"median_ms"/d' "$1/summary.json"
  cut -d, -f1-15,17- "$1/frames.csv"
}

workers() { pgrep -f -- "^$bin/epcc_eval .*--out $dir/out/shards/"; }
parent() { ps -o ppid= -p "$1" | tr -d ' '; }
some_done() { workers && [[ -n $(find "$dir/out/shards" -path '*results*' -name '*.json' -print -quit) ]]; }
restarted() { scontrol show job "$array" | grep -Eq 'Restarts=[1-9]'; }
merged() { [[ -z $(squeue -h -o %i) ]]; }

echo "Rendering frames, one unsharded run" >&2
"$bin/epcc_scene" all --seeds 0:11 --noise stereo --width 320 --height 180 --out "$dir/frames" >/dev/null
evaluate=("$dir/frames" --methods "epcc,region-growing,omps" --pictures 1)
"$bin/epcc_eval" "${evaluate[@]}" --out "$dir/whole" >"$dir/whole.txt"

echo "Starting munged, slurmctld, slurmd" >&2
start_munge
write_config
slurmctld -D -i >"$dir/slurmctld.log" 2>&1 &
pids+=($!)
until_true "slurmctld" scontrol ping
start_slurmd

submit=(env "EPCC_EVAL=$bin/epcc_eval" scripts/slurm/submit.sh --out "$dir/out" --shards "$shards" --throttle 2)
line=$("${submit[@]}" -- "${evaluate[@]}")
echo "Submitted: $line" >&2
array=${line#array }
array=${array%%,*}

until_true "a result" some_done
echo "The node dies: slurmd, and every task with its keeper" >&2
kill -9 "$slurmd_pid"
for worker in $(workers); do
  script=$(parent "$worker")
  kill -9 "$(parent "$script")" "$script" "$worker" 2>/dev/null || true
done
wait "$slurmd_pid" 2>/dev/null || true
before=$(find "$dir/out/shards" -path '*results*' -name '*.json' | wc -l)
start_slurmd
until_true "requeued tasks" restarted
requeued=$(scontrol show job "$array" | grep -Ec 'Restarts=[1-9]')

# A worker may end between being found and being killed: then the next one.
kill_a_worker() {
  worker=$(workers | head -n 1) && kill -9 "$worker"
}
until_true "a worker after the requeue" kill_a_worker
echo "$before results were there; $requeued tasks requeued; then worker $worker killed" >&2

until_true "the merge" merged
[[ -f $dir/out/summary.json ]] || fail "there is no merged report"
diff <(report "$dir/whole") <(report "$dir/out") || fail "the merged report differs from the unsharded one"
echo "Same report from $shards shards on Slurm $(sinfo --version | cut -d' ' -f2) as from one run:"
sed -n '1,5p' "$dir/out/logs/merge.log"
