// SPDX-License-Identifier: BSD-3-Clause
// S3: the planes of both scan directions become labels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "inverse_depth/directional_planes.h"
#include "inverse_depth/region_map.h"

namespace epcc {

/// A pixel takes the larger of its two planes. Keeps its memory between frames.
class DirectionJoining {
 public:
  /// Planes that are large enough get labels by size, the largest 1; of equal ones those of the columns come first.
  void join(const InverseDepthImage& image, const std::array<DirectionalPlanes, 2>& directions, int threads,
            RegionMap& map);

 private:
  /// Of one direction: ranks by size from 0, kNoPlane where there is none.
  struct RanksOf {
    std::vector<std::uint32_t> of_plane;
    /// Per scan line: of no segment, then of each of its segments.
    std::vector<std::uint32_t> of_segment;
    std::vector<std::int32_t> first_segment;  // per scan line: the place of its segment 0
  };
  struct SizedPlane {
    double points;
    std::uint32_t direction, plane;
  };

  void rankPlanes(const std::array<DirectionalPlanes, 2>& directions);
  static void rankSegments(const DirectionalPlanes& direction, RanksOf& ranks);

  std::vector<SizedPlane> planes_;
  std::array<RanksOf, 2> ranks_;
  std::vector<std::int32_t> known_segment_;  // per thread and column
  std::vector<std::uint32_t> known_rank_;
};

}  // namespace epcc
