// SPDX-License-Identifier: BSD-3-Clause
// Moments of labelled pixels, from sums over their rows.
#include "inverse_depth/region_map.h"

#include <algorithm>

#include "inverse_depth/relabelling.h"
#include "parallel_for.h"

namespace epcc {

namespace {

// However many threads there are, the rows are summed in as many bands: one order of all sums.
constexpr int kSummedBands = 4;

PlaneMoments momentsOf(const RaySums& s, bool spherical) {
  PlaneMoments moments;
  const double ff = spherical ? s.one - s.aa : s.one;  // a^2 + f^2 = 1, or f = 1
  moments.n = s.n;
  moments.turning = spherical;
  moments.w_sum = s.w_plain;
  moments.w_w = s.ww;
  moments.rays_w = Eigen::Vector3d(s.aw, s.vw, s.fw);
  moments.rays << s.aa, s.av, s.af, s.av, s.vv, s.fv, s.af, s.fv, ff;
  return moments;
}

void addRows(const InverseDepthImage& image, const std::vector<std::int32_t>& labels, int begin, int end,
             RaySums* sums) {
  LabelledRow row;
  row.width = image.width;
  row.across = image.across.data();
  if (!image.planar_rows) row.forward = image.forward.data();
  for (int r = begin; r < end; ++r) {
    const std::size_t start = image.index(r, 0);
    row.label = labels.data() + start;
    row.w = image.w.data() + start;
    row.weight = image.weight.data() + start;
    row.along = image.along[static_cast<std::size_t>(r)];
    addRow(row, sums);
  }
}

}  // namespace

void RegionMap::accumulate(const InverseDepthImage& image, int threads) {
  const std::size_t count = regions.size();
  sums.resize(static_cast<std::size_t>(kSummedBands) * count);
  sharedFor(kSummedBands, threads, [&](int /*thread*/, int first, int end) {
    for (int band = first; band < end; ++band) {
      RaySums* own = sums.data() + static_cast<std::size_t>(band) * count;
      std::fill(own, own + count, RaySums());
      addRows(image, labels, image.height * band / kSummedBands, image.height * (band + 1) / kSummedBands, own);
    }
  });
  for (std::size_t k = 0; k < count; ++k) {
    RaySums& sum = sums[k];
    for (std::size_t other = k + count; other < sums.size(); other += count) sum += sums[other];
    regions[k] = momentsOf(sum, !image.planar_rows);
  }
}

void MomentMoves::move(const InverseDepthImage& image, int row, int column, std::int32_t from, std::int32_t to) {
  const std::size_t pixel = image.index(row, column);
  const auto t = static_cast<double>(image.weight[pixel]), w = static_cast<double>(image.w[pixel]);
  const double a = image.across[static_cast<std::size_t>(column)], v = image.along[static_cast<std::size_t>(row)];
  const double f = image.forward[static_cast<std::size_t>(column)];
  const double ta = t * a, tv = t * v, tw = t * w;
  const RaySums one = {1.0, w, t, ta * a, ta * f, ta * v, tv * f, tv * v, tw * a, tw * v, tw * f, tw * w};
  gains_[static_cast<std::size_t>(from)] -= one;
  gains_[static_cast<std::size_t>(to)] += one;
}

// A region that has lost all its pixels has exactly none.
void RegionMap::applyMoves(const InverseDepthImage& image) {
  for (std::size_t k = 0; k < regions.size(); ++k) {
    const RaySums& gain = moves.gains()[k + 1];
    if (gain.w_plain == 0.0 && gain.n == 0.0) continue;
    regions[k] += momentsOf(gain, !image.planar_rows);
    if (regions[k].n <= 0.0) regions[k] = PlaneMoments();
  }
}

void RegionMap::relabel(const std::vector<std::int32_t>& new_label, int threads) {
  std::size_t kept = 0;
  while (kept < new_label.size() && new_label[kept] == static_cast<std::int32_t>(kept)) ++kept;
  if (kept == new_label.size()) return;
  const int blocks = static_cast<int>((labels.size() + kRelabelledBlock - 1) / kRelabelledBlock);
  sharedFor(blocks, threads, [&](int /*thread*/, int begin, int end) {
    const std::size_t first = kRelabelledBlock * static_cast<std::size_t>(begin);
    const std::size_t last = std::min(labels.size(), kRelabelledBlock * static_cast<std::size_t>(end));
    relabelPixels(labels.data() + first, last - first, new_label.data());
  });
}

}  // namespace epcc
