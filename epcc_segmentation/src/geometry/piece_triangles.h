// SPDX-License-Identifier: BSD-3-Clause
// A polygon's triangles, checked: they cover it and nothing else.
#pragma once

#include <array>
#include <vector>

#include "geometry/geos_shapes.h"

namespace epcc {

/// Counter-clockwise triangles of the polygon's points. None if it cannot be triangulated.
std::vector<std::array<Vector2, 3>> pieceTriangles(GeosShapes& shapes, const FlatPolygon& polygon);

}  // namespace epcc
