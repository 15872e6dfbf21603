// SPDX-License-Identifier: BSD-3-Clause
// GEOS' constrained triangulation, tried again where it fails.
#include "geometry/piece_triangles.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "geometry/flat_points.h"

namespace epcc {

namespace {

/// GEOS 3.11 joins holes to the outline from left to right, and fails with some. Turned by one of these angles
/// (radians) the same polygon succeeds.
constexpr double kTurns[] = {0.0, 1.1, 2.3, 3.7, 5.0, 0.4, 1.7, 2.9, 4.3, 5.6};
constexpr double kMaxError = 1e-6;  // of the area

void turn(FlatPolygon& polygon, double angle) {
  if (angle == 0.0) return;
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turnRing = [&](FlatRing& ring) {
    for (Vector2& p : ring) p = Vector2(c * p.x() - s * p.y(), s * p.x() + c * p.y());
  };
  turnRing(polygon.outline);
  for (FlatRing& hole : polygon.holes) turnRing(hole);
}

double areaOf(const FlatPolygon& polygon) {
  double area = ringArea(polygon.outline);
  for (const FlatRing& hole : polygon.holes) area -= std::abs(ringArea(hole));
  return area;
}

}  // namespace

std::vector<std::array<std::size_t, 3>> pieceTriangles(GeosShapes& shapes, const FlatPolygon& polygon) {
  const double area = areaOf(polygon);
  std::vector<std::array<std::size_t, 3>> all;
  if (!(area > 0.0)) return all;
  for (const double angle : kTurns) {
    FlatPolygon turned = polygon;
    turn(turned, angle);
    std::unordered_map<Vector2, std::size_t, BitsHash<Vector2>> numbers;
    std::size_t next = 0;
    const auto number = [&](const FlatRing& ring) {
      for (const Vector2& p : ring) numbers.emplace(p, next++);
    };
    number(turned.outline);
    for (const FlatRing& hole : turned.holes) number(hole);
    all.clear();
    double sum = 0.0;
    for (const auto& triangle : shapes.triangles(turned)) {
      std::array<std::size_t, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = numbers.at(triangle[k]);
      all.push_back(corners);
      sum += ringArea({triangle[0], triangle[1], triangle[2]});
    }
    if (std::abs(sum - area) <= kMaxError * area) return all;
  }
  return {};
}

}  // namespace epcc
