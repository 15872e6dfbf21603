// SPDX-License-Identifier: BSD-3-Clause
// A polygon's triangles, checked: they cover it and nothing else.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/geos_shapes.h"

namespace epcc {

/// Counter-clockwise triangles, as numbers of the polygon's points: those of the outline, then hole by hole. A corner
/// where rings touch has one of its numbers. None if the polygon cannot be triangulated.
std::vector<std::array<std::size_t, 3>> pieceTriangles(GeosShapes& shapes, const FlatPolygon& polygon);

}  // namespace epcc
