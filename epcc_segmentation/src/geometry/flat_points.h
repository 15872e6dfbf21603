// SPDX-License-Identifier: BSD-3-Clause
// Points of a surface found again by their place on the plane, and the extent of an outline.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <unordered_map>

#include "epcc_segmentation/surface_polygon.h"
#include "geometry/geos_shapes.h"

namespace epcc {

/// A hash of the bits of N doubles.
template <typename Vector>
struct BitsHash {
  std::size_t operator()(const Vector& v) const {
    std::uint64_t hash = 1469598103934665603ULL;
    for (int k = 0; k < v.size(); ++k) {
      const double value = v(k) + 0.0;  // one zero
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      hash = (hash ^ bits) * 1099511628211ULL;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// Coordinates pass through GEOS unchanged: the bits tell a point.
class FlatPoints {
 public:
  void add(const SurfaceRing& ring) {
    for (std::size_t i = 0; i < ring.flat.size(); ++i) points_.emplace(ring.flat[i], ring.points[i]);
  }
  /// Null if none is there.
  const Vector3* find(const Vector2& flat) const {
    const auto found = points_.find(flat);
    return found == points_.end() ? nullptr : &found->second;
  }

 private:
  std::unordered_map<Vector2, Vector3, BitsHash<Vector2>> points_;
};

/// The smallest rectangle round a convex ring, which has one side on one of the ring's.
OrientedExtent extentOf(const FlatRing& hull, const PlaneBasis& basis);

}  // namespace epcc
