#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Renews the tables and pictures of docs/research/accuracy.md, in about 90 seconds: accuracy.sh [--data DIR] [...]
# Options go to epcc_accuracy. Overlays of every frame and frames.csv are left in results/accuracy/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=results/accuracy
scripts/prepare.sh epcc_accuracy
build/release/bin/epcc_accuracy --out "$out" --page docs/research/accuracy.md "$@"

# Of the frames only rendered scenes may be shown: the real frames are other people's.
cp "$out/curve.png" docs/images/accuracy_curve.png
cp "$out/overlays/b-stereo_0.png" docs/images/accuracy_best.png
cp "$out/overlays/d-stereo_0.png" docs/images/accuracy_worst.png
