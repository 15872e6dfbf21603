// SPDX-License-Identifier: BSD-3-Clause
// S3: planes are ranked once, then every pixel takes the lesser rank of its two segments.
#include "inverse_depth/direction_joining.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/direction_joining.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "inverse_depth/joined_row.h"
#include "parallel_for.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Ints = hn::CappedTag<std::int32_t, 16>;
using Ranks = hn::RebindToUnsigned<Ints>;
using Int = hn::Vec<Ints>;
using Rank = hn::Vec<Ranks>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Ints()));

HWY_INLINE Rank select(hn::Mask<Ints> mask, Rank yes, Rank no) {
  return hn::IfThenElse(hn::RebindMask(Ranks(), mask), yes, no);
}

// The ranks of kLanes pixels by their columns' segments: those that the rows above had go on, the others are looked up.
HWY_INLINE Rank columnRanks(const JoinedRow& in, int column) {
  const Ints d;
  const std::int32_t* segment = in.column_segment + column;
  std::int32_t* known = in.known_segment + column;
  std::uint32_t* rank = in.known_rank + column;
  const Int id = hn::LoadU(d, segment);
  const auto none = hn::Lt(id, hn::Zero(d));
  const auto fresh = hn::Not(hn::Or(none, hn::Eq(id, hn::LoadU(d, known))));
  if (HWY_UNLIKELY(!hn::AllFalse(d, fresh))) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, fresh, bytes);
    for (unsigned lanes = bytes[0] | (static_cast<unsigned>(bytes[1]) << 8); lanes != 0; lanes &= lanes - 1) {
      const auto k = hwy::Num0BitsBelowLS1Bit_Nonzero32(lanes);
      known[k] = segment[k];
      rank[k] = in.column_rank[in.column_first[static_cast<std::size_t>(column) + k] + segment[k]];
    }
  }
  return select(none, hn::Set(Ranks(), kNoPlane), hn::LoadU(Ranks(), rank));
}

/// The segment that a row is in, and its rank.
struct RowSegment {
  Int id;
  Rank rank;
};

HWY_INLINE Rank rowRanks(const JoinedRow& in, int column, RowSegment& current) {
  const Ints d;
  const Int id = hn::LoadU(d, in.row_segment + column);
  auto found = hn::Eq(id, current.id);
  Rank rank = select(found, current.rank, hn::Set(Ranks(), kNoPlane));
  auto rest = hn::AndNot(found, hn::Gt(id, hn::Set(d, -1)));
  while (HWY_UNLIKELY(!hn::AllFalse(d, rest))) {
    const std::int32_t next = in.row_segment[column + static_cast<int>(hn::FindFirstTrue(d, rest))];
    current = {hn::Set(d, next), hn::Set(Ranks(), in.row_rank[next])};
    found = hn::Eq(id, current.id);
    rank = select(found, current.rank, rank);
    rest = hn::AndNot(found, rest);
  }
  return rank;
}

// label = min(rank of the column's plane, rank of the row's plane) + 1, where no plane gives 0.
void joinRow(const JoinedRow& in) {
  const Ranks d;
  RowSegment current = {hn::Set(Ints(), -2), hn::Zero(d)};
  int column = 0;
  for (; column + kLanes <= in.width; column += kLanes) {
    Rank rank = hn::Set(d, kNoPlane);
    if (in.column_segment != nullptr) rank = columnRanks(in, column);
    if (in.row_segment != nullptr) rank = hn::Min(rank, rowRanks(in, column, current));
    hn::StoreU(hn::BitCast(Ints(), hn::Add(rank, hn::Set(d, 1))), Ints(), in.label + column);
  }
  for (; column < in.width; ++column) {
    std::uint32_t rank = kNoPlane;
    if (in.column_segment != nullptr) rank = in.column_rank[in.column_first[column] + in.column_segment[column]];
    if (in.row_segment != nullptr) {
      const std::uint32_t other = in.row_rank[in.row_segment[column]];
      rank = other < rank ? other : rank;
    }
    in.label[column] = static_cast<std::int32_t>(rank + 1);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(joinRow);

void DirectionJoining::join(const InverseDepthImage& image, const std::array<DirectionalPlanes, 2>& directions,
                            int threads, RegionMap& map) {
  rankPlanes(directions);
  for (std::size_t k = 0; k < directions.size(); ++k)
    if (directions[k].active()) rankSegments(directions[k], ranks_[k]);
  map.labels.resize(image.w.size());
  map.regions.assign(planes_.size(), PlaneMoments());
  const auto width = static_cast<std::size_t>(image.width);
  const std::size_t parts = static_cast<std::size_t>(std::max(1, threads));
  known_segment_.assign(parts * width, -1);
  known_rank_.resize(parts * width);

  sharedFor(image.height, threads, [&](int thread, int begin, int end) {
    JoinedRow in;
    in.width = image.width;
    in.known_segment = known_segment_.data() + static_cast<std::size_t>(thread) * width;
    in.known_rank = known_rank_.data() + static_cast<std::size_t>(thread) * width;
    in.column_rank = ranks_[0].of_segment.data();
    in.column_first = ranks_[0].first_segment.data();
    for (int row = begin; row < end; ++row) {
      const std::size_t start = image.index(row, 0);
      in.label = map.labels.data() + start;
      if (directions[0].active()) in.column_segment = directions[0].lines().segmentOf().data() + start;
      if (directions[1].active()) {
        in.row_segment = directions[1].lines().segmentOf().data() + start;
        in.row_rank = ranks_[1].of_segment.data() + ranks_[1].first_segment[static_cast<std::size_t>(row)];
      }
      EPCC_KERNEL(joinRow)(in);
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

void DirectionJoining::rankSegments(const DirectionalPlanes& direction, RanksOf& ranks) {
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
#endif
