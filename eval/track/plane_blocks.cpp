// SPDX-License-Identifier: BSD-3-Clause
// Most squares have one plane; the others are looked at row by row.
#include "eval/track/plane_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace epcc {
namespace {

constexpr double kMostSlant = 1.5;  // depth at the farthest corner to that at the nearest

}  // namespace

std::vector<PlaneBlock> planeBlocks(const std::vector<std::int32_t>& labels, int width, int height, int step, int turn,
                                    int turns) {
  const auto row = [&](int y) { return labels.begin() + static_cast<std::ptrdiff_t>(y) * width; };
  std::vector<PlaneBlock> blocks;
  for (int top = turn * step; top < height; top += turns * step)
    for (int left = 0; left < width; left += step) {
      const int bottom = std::min(top + step, height), right = std::min(left + step, width);
      const std::int32_t first = row(top)[left];
      bool is_whole = true;
      for (int y = top; y < bottom && is_whole; ++y)
        is_whole = std::all_of(row(y) + left, row(y) + right, [first](std::int32_t label) { return label == first; });
      if (is_whole) {
        if (first > 0) blocks.push_back({first, top, bottom, left, right, true});
        continue;
      }
      for (int y = top; y < bottom; ++y)
        for (int x = left, end = left; x < right; x = end) {
          const std::int32_t own = row(y)[x];
          while (end < right && row(y)[end] == own) ++end;
          if (own > 0) blocks.push_back({own, y, y + 1, x, end, false});
        }
    }
  return blocks;
}

PlaneBlock squareAround(const PlaneBlock& block, int step) {
  PlaneBlock square = block;
  square.top -= block.top % step;
  square.left -= block.left % step;
  square.bottom = square.top + step;
  square.right = square.left + step;
  square.is_whole = true;
  return square;
}

std::optional<std::array<Eigen::Vector3d, 4>> footprintOf(const PlaneBlock& block, const PinholeCamera& camera,
                                                          const Eigen::Vector4d& plane) {
  const std::array<int, 4> columns = {block.left, block.right, block.right, block.left},
                           rows = {block.top, block.top, block.bottom, block.bottom};
  std::array<Eigen::Vector3d, 4> corners;
  double nearest = 1e300, farthest = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d ray((columns[i] - 0.5 - camera.cx) / camera.fx, (rows[i] - 0.5 - camera.cy) / camera.fy, 1.0);
    const double z = -plane(3) / plane.head<3>().dot(ray);
    if (!(z > 0.0 && std::isfinite(z))) return std::nullopt;
    nearest = std::min(nearest, z);
    farthest = std::max(farthest, z);
    corners[i] = z * ray;
  }
  if (!(farthest < kMostSlant * nearest)) return std::nullopt;
  return corners;
}

}  // namespace epcc
