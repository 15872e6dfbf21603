// SPDX-License-Identifier: BSD-3-Clause
// Lengths are divided by the stride, areas by its square.
#include "inverse_depth/sample_grid.h"

#include <algorithm>
#include <cmath>

namespace epcc {

namespace {

constexpr double kPixelsPerStride = 320.0;
constexpr int kMaxDefaultStride = 4;

constexpr double kLongerSideOfPixels = 640.0;
constexpr double kMaxShortening = 4.0;

int nearest(int pixels, double scale, int least) {
  return std::max(least, static_cast<int>(std::lround(pixels / scale)));
}

}  // namespace

int longerSide(int width, int height) {
  const auto [shorter, longer] = std::minmax(width, height);
  return std::min(longer, 2 * shorter);
}

int strideFor(int longer_side, int stride) {
  if (stride > 0) return stride;
  return std::clamp(static_cast<int>(std::lround(longer_side / kPixelsPerStride)), 1, kMaxDefaultStride);
}

InverseDepthParameters onGrid(const InverseDepthParameters& parameters, int longer_side, const GridSteps& steps) {
  InverseDepthParameters grid = parameters;
  const double shortening = std::clamp(kLongerSideOfPixels / longer_side, 1.0, kMaxShortening);
  const double scale = std::max(steps.side(), shortening);
  const double area = scale * scale;
  grid.min_points = nearest(parameters.min_points, steps.area(), 1);
  InverseDepthParameters::Expert& expert = grid.expert;
  expert.lines.min_samples = nearest(expert.lines.min_samples, scale, 3);
  // Rounded down: a line that reached farther than before would run across grooves.
  expert.lines.max_gap_pixels = std::max(0, static_cast<int>((expert.lines.max_gap_pixels + 1) / scale) - 1);
  expert.planes.min_overlap_pixels = nearest(expert.planes.min_overlap_pixels, scale, 1);
  expert.planes.min_points = nearest(expert.planes.min_points, area, 1);
  expert.merging.min_bridge_pixels = nearest(expert.merging.min_bridge_pixels, scale, 1);
  expert.merging.min_contacts = nearest(expert.merging.min_contacts, scale, 1);
  // How far borders fray is a matter of the error, not of the faces.
  expert.refinement.crease_vote_pixels = nearest(expert.refinement.crease_vote_pixels, steps.side(), 1);
  expert.refinement.crease_min_votes =
      std::min(expert.refinement.crease_min_votes, nearest(expert.refinement.crease_min_votes, steps.side(), 2));
  return grid;
}

// A blotch smaller than the grid leaves its samples independent: SensorModel sees to it.
SensorModel onGrid(const SensorModel& sensor, const GridSteps& steps) {
  return sensor.withCorrelationLength(sensor.correlationLength() / steps.side());
}

}  // namespace epcc
