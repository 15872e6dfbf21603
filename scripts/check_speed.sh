#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails if a frame takes over 5 % more instructions than tests/bench/instruction_counts.txt has: those that valgrind
# counts do not depend on how busy the machine is. Exit code 77 where it is not installed or cannot count.
#   check_speed.sh [--renew] [BUILD]    --renew writes the file; BUILD: build/release
#
# Counted is extract() on the second frame of each mode, one thread, a rendered scene of 640x480. The vector unit is SSE4,
# whatever the processor has: valgrind knows no AVX-512; AVX2 is missing on some machines; and SSE2 is what the compiler
# makes of emulated lanes. The C library is told the same, for it too chooses its functions by the processor.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

renew=false
if [[ ${1:-} == --renew ]]; then
  renew=true
  shift
fi
program=${1:-build/release}/bin/instruction_count
stored=tests/bench/instruction_counts.txt
cases=(default paper auto)
max_percent=5

if ! command -v valgrind >/dev/null || [[ $(uname -m) != x86_64 ]]; then
  echo "check_speed.sh: it needs valgrind and an x86-64 processor" >&2
  exit 77
fi
if [[ ! -x $program ]]; then
  echo "check_speed.sh: there is no $program: build first (scripts/build.sh release)" >&2
  exit 2
fi
if ! $renew && [[ ! -f $stored ]]; then
  echo "check_speed.sh: there is no $stored: scripts/check_speed.sh --renew writes it" >&2
  exit 2
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$program" render "$folder"

# The instructions of a case in $folder/CASE.
count() {
  local log=$folder/$1.log
  if ! GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-AVX,-FMA,-FMA4,-ERMS,-FSRM,-AVX_Fast_Unaligned_Load EPCC_VECTOR_UNIT=sse4 \
    valgrind --tool=callgrind --collect-atstart=no --toggle-collect=epccCountedFrame \
    --callgrind-out-file="$folder/$1.callgrind" "$program" "$1" "$folder" >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    return 1
  fi
  sed -n 's/^\(summary\|totals\): *//p' "$folder/$1.callgrind" | head -n 1 >"$folder/$1"
}

jobs=()
for case in "${cases[@]}"; do
  count "$case" &
  jobs+=($!)
done
for job in "${jobs[@]}"; do
  if ! wait "$job"; then
    echo "check_speed.sh: valgrind failed" >&2
    exit 1
  fi
done

versions=$("$program" versions)
if $renew; then
  {
    echo "# Instructions of one frame, see scripts/check_speed.sh, which compares and renews them (--renew)."
    echo "versions $versions"
    for case in "${cases[@]}"; do echo "$case $(<"$folder/$case")"; done
  } >"$stored"
  cat "$stored"
  exit 0
fi

recorded=$(sed -n 's/^versions //p' "$stored")
if [[ $versions != "$recorded" ]]; then
  echo "check_speed.sh: this is $versions, $stored was made by $recorded: the numbers may differ for that"
fi
status=0
for case in "${cases[@]}"; do
  before=$(sed -n "s/^$case //p" "$stored")
  now=$(<"$folder/$case")
  if [[ ! $before =~ ^[1-9][0-9]*$ || ! $now =~ ^[1-9][0-9]*$ ]]; then
    echo "check_speed.sh: $case: no count in $stored or by valgrind ('$before', '$now')" >&2
    exit 1
  fi
  awk -v name="$case" -v now="$now" -v before="$before" 'BEGIN {
    printf "%s: %.2f million instructions a frame, stored %.2f (%+.1f %%)\n", name, now / 1e6, before / 1e6,
      100 * (now / before - 1) }'
  if ((now * 100 > before * (100 + max_percent))); then
    echo "check_speed.sh: $case takes over $max_percent % more instructions: $now, stored $before. If that is meant," \
      "scripts/check_speed.sh --renew writes $stored anew" >&2
    status=1
  elif ((now * 100 < before * (100 - max_percent))); then
    echo "$case became faster: scripts/check_speed.sh --renew keeps it so"
  fi
done
exit $status
