#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What happens to epcc_eval may not cost a result: killed again and again, two at a time in one folder, a full disk, a
# read-only one, little memory. Each time the report in the end must be that of a run left alone, to the byte.
#   fault_test.sh [--kills N] [--frames N] [BUILD]    N kills (200); frames in the large folder (2000); BUILD:
#                                                     build/release, made if it is not given
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

kills=200 many=2000 build=
while (($#)); do
  case $1 in
    --kills) kills=$2; shift 2 ;;
    --frames) many=$2; shift 2 ;;
    *) build=$1; shift ;;
  esac
done
[[ -n $build ]] || scripts/prepare.sh epcc_eval epcc_scene
bin=$(cd "${build:-build/release}" && pwd)/bin

dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"

fail() {
  echo "fault_test.sh: $1" >&2
  cat err >&2 2>/dev/null || true
  exit 1
}

command=("$bin/epcc_eval" rooms halls --methods "epcc,omps" --overlays --no-times)
evaluate() { "${command[@]}" "$@" >out 2>err; }

# same FOLDER: it holds the files of the run left alone, with the same bytes, and no others. How the run was made
# may differ.
same() {
  diff -r --exclude=.epcc-lock --exclude=run.json whole "$1" >difference ||
    fail "$1: $(head -n 3 difference)"
}

# told CODE WORDS: the last run ended with the code and one line that has the words.
told() {
  [[ $code == "$1" ]] || fail "exit code $code, not $1"
  [[ $(wc -l <err) == 1 && $(<err) == "epcc_eval: "*"$2"* ]] || fail "not one line with '$2'"
}

"$bin/epcc_scene" all --seeds 0:2 --noise stereo --width 160 --height 120 --out rooms >/dev/null
"$bin/epcc_scene" b --seeds 5:6 --noise stereo --width 160 --height 120 --out halls >/dev/null
echo broken >rooms/a_001_depth.png
frames=14
start=${EPOCHREALTIME/./}
evaluate --out whole
length=$((${EPOCHREALTIME/./} - start))

# The first run of each way to do the frames is in threads, the second in processes of their own.
ways=("--jobs 2" "--jobs 2 --frame-timeout 600")

# The phase that a killed run was in, by what it has left.
phase() {
  local results
  [[ -f run/run.json ]] || { echo "before the first frame"; return; }
  results=$(find run/results -name '*.json' 2>/dev/null | wc -l)
  if ((results == 0)); then
    echo "before the first frame"
  elif ((results < frames)); then
    echo "at the frames"
  elif [[ -f run/report.html ]]; then
    echo "after the report"
  else
    echo "at the report"
  fi
}

declare -A phases=()
killed=0 whole_runs=0 half_written=0 reach=$length
while ((killed < kills)); do
  read -ra way <<<"${ways[whole_runs % 2]}"
  "${command[@]}" --out run --resume "${way[@]}" >out 2>err &
  process=$!
  sleep "$(awk -v reach="$reach" -v a=$RANDOM 'BEGIN { printf "%.4f", 1e-6 * reach * a / 32768 }')"
  kill -9 "$process" 2>/dev/null || true
  code=0
  wait "$process" 2>/dev/null || code=$?
  if ((code == 137)); then
    ((++killed))
    reach=$((reach * 5 / 4)) # so that a run is left alone to its end before long, on a busy machine too
    ((++phases["$(phase)"]))
    if [[ -n $(find run -name '*.tmp' 2>/dev/null) ]]; then ((++half_written)); fi
  elif ((code == 0)); then
    same run
    rm -rf run
    ((++whole_runs))
    reach=$length
  else
    fail "gone on with, it ends with exit code $code"
  fi
done
evaluate --out run --resume "${way[@]}" || fail "the last run fails"
same run
rm -rf run
echo "Killed $killed times, $((whole_runs + 1)) reports, all the same; a file was half written $half_written times"
for name in "${!phases[@]}"; do echo "  killed $name: ${phases[$name]}"; done

# The first stands still in the middle, with the folder in its hands.
"${command[@]}" --out run >out 2>err &
process=$!
until [[ -f run/run.json || ! -d /proc/$process ]]; do sleep 0.001; done
kill -STOP "$process"
mv err err_first
code=0
evaluate --out run --resume || code=$?
told 4 "run: folder: another process is at work in it"
kill -CONT "$process"
wait "$process" || fail "the first of two is disturbed"
same run
code=0
evaluate --out run || code=$?
told 2 "has results already"
rm -rf run
echo "Two in one folder: the second is told, the first goes on"

# Little memory: a large frame is an error, many small ones are not.
mkdir many
mapfile -t names < <(find rooms -name '*_depth.png' ! -name 'a_001*' | sed 's/_depth\.png$//' | sort)
for ((i = 0; i < many; ++i)); do
  for part in _depth.png _labels.png .json; do
    printf '%s\0many/f%07d%s\0' "${names[i % ${#names[@]}]}$part" "$i" "$part"
  done
done | xargs -0 -n 2 ln
/usr/bin/python3 - <<'END'
import struct, zlib
side = 8000
def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
for name, value in (("depth", 2000), ("labels", 1)):
    row = b"\0" + struct.pack(">H", value) * side
    with open(f"many/large_{name}.png", "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", side, side, 16, 0, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(row * side)) + chunk(b"IEND", b""))
with open("many/large.json", "w") as file:
    file.write('{"width": 8000, "height": 8000, "fx": 6000, "fy": 6000, "cx": 4000, "cy": 4000, "depth_scale": 0.001}')
END
# Each process has its own memory; threads share one, so that a large frame could take it from a small one.
for way in "--jobs 1" "--jobs 2 --frame-timeout 600"; do
  read -ra words <<<"$way"
  code=0
  (ulimit -v $((2 * 1024 * 1024)) &&
    "$bin/epcc_eval" many --methods omps --no-times "${words[@]}" --out run >out 2>err) || code=$?
  ((code == 0)) || fail "2 GB of address space: exit code $code"
  [[ $(head -n 1 err) == "epcc_eval: many/large: omps: needs more memory than there is" ]] ||
    fail "the large frame is not named"
  [[ $(tail -n 1 err) == "epcc_eval: 1 error, $many results scored" ]] || fail "a small frame is lost"
  [[ $(wc -l <err) == 2 ]] || fail "more than that is told"
  rm -rf run
done
rm -rf many
echo "2 GB of address space: $many frames scored, one of 64 million pixels named"

# A disk of its own for the next two takes a mount namespace; root has one, others where the system lets them.
namespace=(unshare --mount)
((EUID == 0)) || namespace+=(--user --map-root-user)
mkdir disk
if ! "${namespace[@]}" mount -t tmpfs -o size=1m tmpfs disk 2>/dev/null; then
  echo "Full and read-only disks: skipped, no file system can be mounted here"
  exit 0
fi
{
  declare -f evaluate same fail told
  declare -p command
  cat <<'END'
full=0
for ((kb = 16;; kb = kb * 3 / 2)); do
  mount -t tmpfs -o size="${kb}k" tmpfs disk
  code=0
  if ((full % 2)); then way=(--frame-timeout 600); else way=(); fi
  evaluate --out disk/run "${way[@]}" || code=$?
  if ((code != 0)); then
    grep -v '^epcc_eval: rooms/a_001: ' err >rest && mv rest err
    told 4 "No space left on device"
    [[ -z $(find disk -name '*.tmp') ]] || fail "$kb kB: a file half written is left"
    ((++full))
    mount -o remount,size=64m disk
    evaluate --out disk/run --resume "${way[@]}" || fail "$kb kB: it cannot be gone on with"
  fi
  same disk/run
  umount disk
  ((code != 0)) || break
done
((full > 5)) || fail "the disk was full $full times only"
echo "Disk full at $full sizes: told, and gone on with"

mount -t tmpfs -o size=64m tmpfs disk
evaluate --out disk/run
for out in disk/run disk/other; do
  mount -o remount,ro disk
  code=0
  evaluate --out "$out" --resume || code=$?
  told 4 "$out"
  [[ $(<err) == *"Read-only file system"* ]] || fail "the reason is not told"
  mount -o remount,rw disk
done
same disk/run
echo "Read-only disk: told, nothing changed"
END
} | "${namespace[@]}" bash -euo pipefail
