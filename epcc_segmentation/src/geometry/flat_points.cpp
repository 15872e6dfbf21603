// SPDX-License-Identifier: BSD-3-Clause
// The rectangle of least area: each side of the hull is tried.
#include "geometry/flat_points.h"

#include <algorithm>
#include <limits>

namespace epcc {

OrientedExtent extentOf(const FlatRing& hull, const PlaneBasis& basis) {
  OrientedExtent extent;
  extent.center = basis.origin;
  extent.long_axis = basis.across;
  extent.short_axis = basis.up;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d side = hull[i + 1 < hull.size() ? i + 1 : 0] - hull[i];
    if (!(side.norm() > 0.0)) continue;
    Eigen::Vector2d along = side.normalized(), beside(-along.y(), along.x());
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vector2& p : hull) {
      const Eigen::Vector2d own(along.dot(p), beside.dot(p));
      low = low.cwiseMin(own);
      high = high.cwiseMax(own);
    }
    const Eigen::Vector2d size = high - low, middle = 0.5 * (low + high);
    if (!(size.x() * size.y() < least)) continue;
    least = size.x() * size.y();
    extent.center = basis.point(middle.x() * along + middle.y() * beside);
    if (size.x() < size.y()) {
      along = beside;
      beside = Eigen::Vector2d(-along.y(), along.x());
    }
    extent.long_axis = along.x() * basis.across + along.y() * basis.up;
    extent.short_axis = beside.x() * basis.across + beside.y() * basis.up;
    extent.length = size.maxCoeff();
    extent.width = size.minCoeff();
  }
  return extent;
}

}  // namespace epcc
