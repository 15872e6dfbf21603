#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Each installed program says its version and does a real job; so does the Python module. Run where the packages are
# installed, in a folder to write to; epcc_view draws its window where there is xvfb-run.
set -euo pipefail

work=$(mktemp -d -p .)
cd "$work"
expect() { # expect WHAT COMMAND...: fails with a line that says what did not work
  local what=$1
  shift
  if ! "$@" >log 2>&1; then
    cat log >&2
    echo "run_programs.sh: $what: failed: $*" >&2
    exit 1
  fi
}

for program in epcc_compare epcc_eval epcc_lines epcc_noise epcc_scene epcc_segment epcc_track epcc_view; do
  expect "$program --version" "$program" --version
  grep -qE "^$program [0-9]+\.[0-9]+\.[0-9]+$" log
  expect "$program has a page" test -s "/usr/share/man/man1/$program.1.gz"
  expect "$program is completed" \
    bash -c "source /usr/share/bash-completion/completions/$program && complete -p $program"
done

expect "frames" epcc_scene a --noise stereo --count 2 --out scenes
expect "planes" epcc_segment scenes/a_000_depth.png --labels labels.png --planes planes.json --overlay overlay.png \
  --cloud cloud.pcd --mesh mesh.ply --polygons polygons.json
for file in labels.png planes.json overlay.png cloud.pcd mesh.ply polygons.json; do test -s "$file"; done
expect "planes of a cloud" epcc_segment cloud.pcd --planes cloud_planes.json
expect "scores of every method" epcc_eval scenes --out scores
grep -q '"method": *"omps"' scores/summary.json
expect "a sequence" epcc_scene a --path sway --frames 5 --noise stereo --out sequence
expect "planes over time" epcc_track sequence --out run
for file in tracks.json trajectory.txt map.png map.ply times.csv; do test -s "run/$file"; done
expect "noise" epcc_noise scenes --out sensor
expect "comparison" epcc_compare --scenes a --seeds 1 --slow-seeds 1 --out comparison
python3 - >scans.csv <<'SCANS'
import math
print("angle_min,angle_increment,ranges")
print("-1.0,0.01," + ",".join(f"{2 / math.cos(-1.0 + 0.01 * i):.4f}" for i in range(201)))
SCANS
expect "lines" epcc_lines scans.csv --noise 0.01,0 --out lines
if command -v xvfb-run >/dev/null; then
  expect "window" xvfb-run -a epcc_view scenes/a_000_depth.png --snapshot window.png
  test -s window.png
fi

expect "Python" python3 - <<'PYTHON'
import epcc
import numpy

rows = (numpy.arange(120) - 59.5) / 130
column = numpy.where(rows > 0.3, 0.6 / numpy.maximum(rows, 0.01), 2.0).astype(numpy.float32)
depth = numpy.repeat(column[:, None], 160, 1)
result = epcc.segment(depth, epcc.PinholeCamera(width=160, height=120, fx=130, fy=130, cx=79.5, cy=59.5))
assert len(result.planes) == 2 and result.labels.shape == (120, 160), result
assert epcc.__file__.startswith("/usr/lib/python3/dist-packages/"), epcc.__file__
PYTHON
echo "every program and the Python module did their job"
