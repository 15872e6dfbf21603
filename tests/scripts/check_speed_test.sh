#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Shows that check_speed.sh lets the stored counts and 5 % more pass, fails beyond, says what changed, and writes anew;
# on a valgrind and a program that are made up.
set -euo pipefail

check=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/scripts/check_speed.sh
[[ $(uname -m) == x86_64 ]] || exit 77
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
mkdir -p "$dir/scripts" "$dir/tests/bench" "$dir/build/release/bin" "$dir/path"
cp "$check" "$dir/scripts"
stored=$dir/tests/bench/instruction_counts.txt

cat >"$dir/build/release/bin/instruction_count" <<'END'
#!/bin/sh
if [ "$1" = versions ]; then echo "GCC 1"; fi
END
# Counts what its environment says, for the case before the folder.
cat >"$dir/path/valgrind" <<'END'
#!/bin/bash
for argument; do
  case $argument in --callgrind-out-file=*) out=${argument#*=} ;; esac
done
name=${*: -2:1}
printf 'events: Ir\nsummary: %s\n' "${!name}" >"$out"
END
chmod +x "$dir/build/release/bin/instruction_count" "$dir/path/valgrind"
export PATH=$dir/path:$PATH
export default=1000000 paper=2000000 auto=3000000

fail() {
  echo "check_speed_test.sh: $1" >&2
  cat "$dir/output" >&2
  exit 1
}

# expect CODE TEXT [OPTION...]: the check's exit code, and what it says.
expect() {
  local code=0
  "$dir/scripts/check_speed.sh" "${@:3}" >"$dir/output" 2>&1 || code=$?
  ((code == $1)) || fail "exit code $code, not $1"
  grep -qF -- "$2" "$dir/output" || fail "it does not say: $2"
}

expect 2 "--renew writes it"
expect 0 "paper 2000000" --renew
expect 0 "auto: 3.00 million instructions a frame, stored 3.00 (+0.0 %)"
default=1050000 expect 0 "default: 1.05 million instructions a frame, stored 1.00 (+5.0 %)"
default=1050001 expect 1 "default takes over 5 % more instructions: 1050001, stored 1000000. If that is meant"
paper=1800000 expect 0 "paper became faster"
paper='' expect 1 "paper: no count"
sed -i 's/GCC 1/GCC 2/' "$stored"
auto=3200000 expect 1 "was made by GCC 2: the numbers may differ"
