// SPDX-License-Identifier: BSD-3-Clause
// What GEOS is asked for: whether polygons are valid, mending them, hulls, triangles, and what lies inside.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "epcc_segmentation/vectors.h"

namespace epcc {

/// A closed line, its last point joined to the first.
using FlatRing = std::vector<Vector2>;

/// A polygon with holes.
struct FlatPolygon {
  FlatRing outline;
  std::vector<FlatRing> holes;
};

/// Twice the area would be the sum of cross products: positive if counter-clockwise.
double ringArea(const FlatRing& ring);

/// A thread's use of GEOS. What GEOS cannot do comes back as nothing; nothing is thrown but std::bad_alloc.
class GeosShapes {
 public:
  GeosShapes();
  ~GeosShapes();
  GeosShapes(const GeosShapes&) = delete;
  GeosShapes& operator=(const GeosShapes&) = delete;

  /// Nothing if the polygons, taken as one multi-polygon, are valid; else a place where they are not.
  std::optional<Vector2> flaw(const std::vector<FlatPolygon>& polygons);
  /// Valid polygons of the same lines (MakeValid), outlines counter-clockwise and holes clockwise.
  std::vector<FlatPolygon> mended(const std::vector<FlatPolygon>& polygons);
  /// The convex hull of points, counter-clockwise; fewer than three if they have none.
  FlatRing hull(const FlatRing& points);
  /// Constrained Delaunay triangles, counter-clockwise, of the polygon's points; none if GEOS fails.
  std::vector<std::array<Vector2, 3>> triangles(const FlatPolygon& polygon);

 private:
  struct Handle;
  void throwIfRanOut() const;
  Handle* handle_;
};

}  // namespace epcc
