// SPDX-License-Identifier: BSD-3-Clause
// GEOS' constrained triangulation, and what is done where it fails.
#include "geometry/piece_triangles.h"

#include <cmath>
#include <cstdio>

namespace epcc {

std::vector<std::array<Vector2, 3>> pieceTriangles(GeosShapes& shapes, const FlatPolygon& polygon) {
  auto all = shapes.triangles(polygon);
  double area = ringArea(polygon.outline), sum = 0.0;
  for (const FlatRing& hole : polygon.holes) area -= std::abs(ringArea(hole));
  for (const auto& t : all) sum += ringArea({t[0], t[1], t[2]});
  if (std::abs(area - sum) > 1e-6 * area)
    std::fprintf(stderr, "triangulation: %g of %g, %zu holes\n", sum, area, polygon.holes.size());
  return all;
}

}  // namespace epcc
