// SPDX-License-Identifier: BSD-3-Clause
// Feet and rays on planes; a grid cut by the polygon's sides, row by row.
#include "epcc_segmentation/surface_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epcc {

namespace {

/// Where a row of the grid meets the polygon's sides, in order.
void crossings(const SurfaceRing& ring, double y, std::vector<double>& at) {
  const std::size_t n = ring.flat.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2& a = ring.flat[i];
    const Vector2& b = ring.flat[i + 1 < n ? i + 1 : 0];
    if ((a.y() <= y) == (b.y() <= y)) continue;  // a side counts with its lower end
    at.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
}

}  // namespace

std::vector<Vector3> sampleSurface(const SurfacePolygon& surface, double spacing, std::size_t max_points) {
  std::vector<Vector3> points;
  if (!(spacing > 0.0) || !std::isfinite(spacing) || surface.pieces.empty()) return points;
  if (surface.area / (spacing * spacing) > static_cast<double>(max_points)) return points;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const SurfacePiece& piece : surface.pieces)
    for (const Vector2& p : piece.outline.flat) {
      low = std::min(low, p.y());
      high = std::max(high, p.y());
    }
  if ((high - low) / spacing > static_cast<double>(max_points)) return points;
  std::vector<double> at;
  for (double row = std::ceil(low / spacing); row * spacing <= high; row += 1.0) {
    at.clear();
    for (const SurfacePiece& piece : surface.pieces) {
      crossings(piece.outline, row * spacing, at);
      for (const SurfaceRing& hole : piece.holes) crossings(hole, row * spacing, at);
    }
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0; i + 1 < at.size(); i += 2)
      for (double column = std::ceil(at[i] / spacing); column * spacing <= at[i + 1]; column += 1.0) {
        if (points.size() == max_points) return {};
        points.push_back(surface.basis.point(Vector2(column * spacing, row * spacing)));
      }
  }
  return points;
}

std::vector<Vector3f> pointsOnPlanes(const DepthFrame& frame, const PlaneSegmentation& segmentation,
                                     OutlinePlacement placement) {
  const std::size_t pixels =
      static_cast<std::size_t>(std::max(0, frame.width())) * static_cast<std::size_t>(std::max(0, frame.height()));
  std::vector<Vector3f> points;
  if (segmentation.labels.size() != pixels) return points;
  points.assign(pixels, Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  const Eigen::Vector3d sensor = frame.fromScan(Eigen::Vector3d::Zero());
  Eigen::Vector3d p;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) {
      const std::size_t i = frame.index(row, column);
      if (!frame.point(row, column, p)) continue;
      const std::int32_t label = segmentation.labels[i];
      if (label > 0 && static_cast<std::size_t>(label) <= segmentation.planes.size()) {
        const Plane& plane = segmentation.planes[static_cast<std::size_t>(label - 1)];
        const double from = plane.signedDistance(sensor), to = plane.signedDistance(p);
        const double share = from / (from - to);  // of the way from the sensor to the point
        if (placement == OutlinePlacement::AlongRay && share > 0.0 && std::isfinite(share))
          p = sensor + share * (p - sensor);
        else
          p = plane.project(p);
      }
      points[i] = p.cast<float>();
    }
  return points;
}

}  // namespace epcc
