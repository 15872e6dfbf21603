#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Shows what the segmenter finds in real depth data: prints the planes and leaves pictures in results/demo/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

clouds=(milk_cartoon_all_small_clorox.pcd table_scene_mug_stereo_textured.pcd)
cache=build/demo
out=results/demo
log=$cache/log

# Runs a step quietly; its output is shown only if it fails.
quietly() {
  if ! "$@" >"$log" 2>&1; then
    tail -n 30 "$log" >&2
    echo "demo.sh: failed: $*" >&2
    exit 1
  fi
}

# Package lists may be missing on a fresh machine, and need root to be fetched.
download_package() {
  local options=(-o APT::Sandbox::User="$(id -un)" -o Acquire::Retries=3)
  apt-get "${options[@]}" download python3-pcl && return
  if ((EUID == 0)); then apt-get "${options[@]}" update; else sudo apt-get "${options[@]}" update; fi
  apt-get "${options[@]}" download python3-pcl
}

# The two clouds are examples in Debian's python3-pcl (PCL's data, BSD); it is unpacked, not installed.
fetch_clouds() {
  local cloud found
  (cd "$cache" && download_package)
  dpkg -x "$cache"/python3-pcl_*.deb "$cache/package"
  for cloud in "${clouds[@]}"; do
    found=$(find "$cache/package" -name "$cloud" -print -quit)
    cp "$found" "$cache/$cloud"
  done
  rm -rf "$cache/package" "$cache"/python3-pcl_*.deb
}

scripts/prepare.sh epcc_segment
mkdir -p "$cache" "$out"
for cloud in "${clouds[@]}"; do
  if [[ ! -s $cache/$cloud ]]; then
    quietly fetch_clouds
    break
  fi
done

segment=build/release/bin/epcc_segment
"$segment" "$cache/${clouds[0]}" --noise kinect-v1 --out "$out" --timing
"$segment" "$cache/${clouds[1]}" --noise realsense --out "$out" --timing
frames=../shared/data/realsense
if [[ -d $frames ]]; then
  "$segment" "$frames" --out "$out" --timing
else
  echo "No frames in $frames: only the two clouds are shown."
fi

echo
echo "Pictures, labels, planes and clouds are in $out/:"
ls "$out"/*_overlay.png
