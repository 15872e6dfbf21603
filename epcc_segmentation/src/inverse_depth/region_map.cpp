// SPDX-License-Identifier: BSD-3-Clause
// Moments of labelled pixels: sums along a run of a row, spread to three dimensions once a run.
#include "inverse_depth/region_map.h"

namespace epcc {

namespace {

/// Sums along a run of one row; the rays are (a, along, f).
struct RunSums {
  double n = 0.0, w_plain = 0.0;
  double one = 0.0, a = 0.0, aa = 0.0, f = 0.0, ff = 0.0, af = 0.0;
  double w = 0.0, aw = 0.0, fw = 0.0, ww = 0.0;

  void add(double across, double forward, double value, double variance) {
    const double weight = 1.0 / variance;
    n += 1.0;
    w_plain += value;
    one += weight;
    a += weight * across;
    aa += weight * across * across;
    f += weight * forward;
    ff += weight * forward * forward;
    af += weight * across * forward;
    const double weighted = weight * value;
    w += weighted;
    aw += weighted * across;
    fw += weighted * forward;
    ww += weighted * value;
  }
  void addTo(PlaneMoments& moments, double along) const {
    moments.n += n;
    moments.w_sum += w_plain;
    moments.w_w += ww;
    moments.rays_w += Eigen::Vector3d(aw, along * w, fw);
    Eigen::Matrix3d m;
    m << aa, along * a, af, along * a, along * along * one, along * f, af, along * f, ff;
    moments.rays += m;
  }
};

}  // namespace

void RegionMap::accumulate(const InverseDepthImage& image) {
  for (auto& region : regions) region = PlaneMoments();
  for (int row = 0; row < image.height; ++row) {
    const std::size_t start = static_cast<std::size_t>(row) * image.width;
    int column = 0;
    while (column < image.width) {
      const std::int32_t label = labels[start + column];
      if (label == 0) {
        ++column;
        continue;
      }
      RunSums run;
      for (; column < image.width && labels[start + column] == label; ++column) {
        const double w = static_cast<double>(image.w[start + column]);
        run.add(image.across[static_cast<std::size_t>(column)], image.forward[static_cast<std::size_t>(column)], w,
                image.variance(w, row));
      }
      run.addTo(regions[static_cast<std::size_t>(label - 1)], image.along[static_cast<std::size_t>(row)]);
    }
  }
}

void RegionMap::relabel(const std::vector<std::int32_t>& new_label) {
  for (auto& label : labels) label = new_label[static_cast<std::size_t>(label)];
}

}  // namespace epcc
