// SPDX-License-Identifier: BSD-3-Clause
// S3: planes are ranked once, then every pixel takes the lesser rank of its two segments.
#include "inverse_depth/direction_joining.h"

#include <algorithm>
#include <limits>

#include "parallel_for.h"

namespace epcc {

namespace {

constexpr std::uint32_t kNoPlane = std::numeric_limits<std::uint32_t>::max();  // label 0 is the rank plus one

}  // namespace

void DirectionJoining::join(const InverseDepthImage& image, const std::array<DirectionalPlanes, 2>& directions,
                            int threads, RegionMap& map) {
  rankPlanes(directions);
  for (std::size_t k = 0; k < directions.size(); ++k)
    if (directions[k].active()) rankSegments(directions[k], ranks_[k]);
  map.labels.resize(image.w.size());
  map.regions.assign(planes_.size(), PlaneMoments());

  const bool columns = directions[0].active(), rows = directions[1].active();
  parallelFor(image.height, threads, [&](int /*thread*/, int begin, int end) {
    for (int row = begin; row < end; ++row) {
      const std::size_t start = image.index(row, 0);
      const std::int32_t* column_segment = columns ? directions[0].lines().segmentOf().data() + start : nullptr;
      const std::int32_t* column_first = ranks_[0].first_segment.data();
      const std::uint32_t* column_rank = ranks_[0].of_segment.data();
      const std::int32_t* row_segment = rows ? directions[1].lines().segmentOf().data() + start : nullptr;
      const std::uint32_t* row_rank =
          rows ? ranks_[1].of_segment.data() + ranks_[1].first_segment[static_cast<std::size_t>(row)] : nullptr;
      std::int32_t* label = map.labels.data() + start;
      for (int column = 0; column < image.width; ++column) {
        std::uint32_t rank = kNoPlane;
        if (columns) rank = column_rank[column_first[column] + column_segment[column]];
        if (rows) rank = std::min(rank, row_rank[row_segment[column]]);
        label[column] = static_cast<std::int32_t>(rank + 1);
      }
    }
  });
}

void DirectionJoining::rankPlanes(const std::array<DirectionalPlanes, 2>& directions) {
  planes_.clear();
  for (std::uint32_t k = 0; k < directions.size(); ++k) {
    const std::vector<double>& points = directions[k].planePoints();
    ranks_[k].of_plane.assign(points.size(), kNoPlane);
    for (std::uint32_t plane = 0; plane < points.size(); ++plane)
      if (points[plane] > 0.0) planes_.push_back({points[plane], k, plane});
  }
  std::sort(planes_.begin(), planes_.end(), [](const SizedPlane& a, const SizedPlane& b) {
    if (a.points != b.points) return a.points > b.points;
    return a.direction != b.direction ? a.direction < b.direction : a.plane < b.plane;
  });
  for (std::uint32_t rank = 0; rank < planes_.size(); ++rank)
    ranks_[planes_[rank].direction].of_plane[planes_[rank].plane] = rank;
}

void DirectionJoining::rankSegments(const DirectionalPlanes& direction, Ranks& ranks) {
  ranks.of_segment.clear();
  ranks.first_segment.clear();
  const int* plane = direction.planeOf().data();
  for (int line = 0; line < direction.lines().scanLines(); ++line) {
    ranks.of_segment.push_back(kNoPlane);
    ranks.first_segment.push_back(static_cast<std::int32_t>(ranks.of_segment.size()));
    for (int k = 0; k < direction.lines().lineCount(line); ++k)
      ranks.of_segment.push_back(ranks.of_plane[static_cast<std::size_t>(*plane++)]);
  }
}

}  // namespace epcc
