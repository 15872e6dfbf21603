// SPDX-License-Identifier: BSD-3-Clause
// Plane -> inliers -> quadrics.
#include "sensor/block_residuals.h"

namespace epcc {

namespace {
constexpr double kMinInlierShare = 0.75;
}

std::optional<BlockResiduals> measureBlock(const InverseDepthImage& image, const BlockPlace& place, double full_share) {
  FittedBlock block;
  if (!fitBlock(image, place, block, full_share)) return std::nullopt;
  const QuadricResiduals quadrics = fitQuadrics(block.samples, block.rays, block.plane, block.gate, full_share);
  if (quadrics.inliers < kMinInlierShare * block.samples.valid) return std::nullopt;
  BlockResiduals result;
  result.depth = block.depth;
  result.slant = 1.0 + block.tan2;
  result.step = block.step * block.to_depth;
  result.place = place;
  result.w = block.w;
  result.w_right = static_cast<double>(block.plane.x);
  result.w_down = static_cast<double>(block.plane.y);
  result.bent = quadrics.bent;
  const double whole = quadrics.squares[kScales - 1];
  result.deviation = std::sqrt(whole / result.slant) * block.to_depth;
  if (!std::isfinite(result.deviation) || !std::isfinite(result.depth)) return std::nullopt;  // absurd values
  for (std::size_t scale = 0; scale + 1 < kScales; ++scale)
    result.kept[scale] = whole > 0.0 ? quadrics.squares[scale] / whole : 1.0;
  return result;
}

}  // namespace epcc
