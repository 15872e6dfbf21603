#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Memory and time of epcc_eval over 1000 and 10000 frames of 160x120, where both must stay flat, over frames of 640x480,
# and what 2.5 million frames would take: the tables of docs/reference/evaluation.md. About six minutes.
# Frames are hard links to a few rendered ones, so the disk holds those once. Times are processor times of one thread.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install_packages.sh time
scripts/prepare.sh epcc_eval epcc_scene
bin=$PWD/build/release/bin
all="epcc,epcc-paper,region-growing,ransac,omps"

dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
"$bin/epcc_scene" all --seeds 0:11 --noise stereo --width 160 --height 120 --out "$dir/160x120" >/dev/null
"$bin/epcc_scene" all --seeds 0:3 --noise stereo --width 640 --height 480 --out "$dir/640x480" >/dev/null

# frames SIZE COUNT: a folder with so many frames; prints its path.
frames() {
  local folder=$dir/frames_$1_$2 names i part
  if [[ ! -d $folder ]]; then
    mkdir "$folder"
    mapfile -t names < <(find "$dir/$1" -name '*_depth.png' | sed 's/_depth\.png$//' | sort)
    for ((i = 0; i < $2; ++i)); do
      for part in _depth.png _labels.png .json; do
        printf '%s\0%s/f%07d%s\0' "${names[i % ${#names[@]}]}$part" "$folder" "$i" "$part"
      done
    done | xargs -0 -n 2 -P "$(nproc)" ln
  fi
  echo "$folder"
}

# measured COMMAND...: prints "cpu_seconds peak_kB".
measured() {
  /usr/bin/time -o "$dir/time" -f '%U %S %M' "$@" >/dev/null
  awk '{ print $1 + $2, $3 }' "$dir/time"
}

# evaluate SIZE COUNT METHODS: prints "cpu_seconds peak_kB kB_on_disk" and leaves the results.
evaluate() {
  local folder out=$dir/out_$1_$2
  folder=$(frames "$1" "$2")
  rm -rf "$out"
  echo "$(measured "$bin/epcc_eval" "$folder" --methods "$3" --out "$out") $(du -s "$out" | cut -f1)"
}

row() { awk -v name="$1" -v n="$2" '{ printf "| %s | %d | %.2f | %.1f | %.1f |\n", name, n, 1e3 * $1 / n, $2 / 1024, $3 / n }'; }

echo "| frames, methods | number | ms a frame | peak memory MB | kB a frame on disk |"
echo "|---|---:|---:|---:|---:|"
small=$(evaluate 160x120 1000 epcc)
row "160x120, epcc" 1000 <<<"$small"
large=$(evaluate 160x120 10000 epcc)
row "160x120, epcc" 10000 <<<"$large"
merge=$(measured "$bin/epcc_eval" merge "$dir/out_160x120_10000" --out "$dir/merged")
row "merge of the second row" 10000 <<<"$merge 0"
# Once more: what else the machine does meanwhile is not growth.
again=$(evaluate 160x120 1000 epcc)
one=$(evaluate 640x480 96 epcc)
row "640x480, epcc" 96 <<<"$one"
five=$(evaluate 640x480 16 "$all")
row "640x480, all five" 16 <<<"$five"

# hours COUNT RESULT: of 2.5 million frames on 1, 16, 64 and 1024 cores, the merger's time added.
hours() {
  echo "$2 $1 $merge" | awk '{ merge = 250 * $5 / 3600
    for (cores = 1; cores <= 1024; cores *= cores < 64 && cores > 1 ? 4 : 16)
      printf " %.2f |", 2.5e6 * $1 / $4 / cores / 3600 + merge }'
}
echo
echo "| 2.5 million frames, hours on | 1 core | 16 | 64 | 1024 |"
echo "|---|---:|---:|---:|---:|"
echo "| 160x120, epcc |$(hours 10000 "$large")"
echo "| 640x480, epcc |$(hours 96 "$one")"
echo "| 640x480, all five |$(hours 16 "$five")"

# Flat: a tenth more time than the slower of the runs before and after, and five MB more memory, would be growth.
awk -v s="$small" -v l="$large" -v r="$again" 'BEGIN { split(s, a); split(l, b); split(r, c)
  slower = a[1] > c[1] ? a[1] : c[1]
  exit !(b[1] / 10000 < 1.1 * slower / 1000 && b[2] < a[2] + 5 * 1024) }' ||
  { echo "scale_test.sh: time or memory grows with the number of frames" >&2; exit 1; }
