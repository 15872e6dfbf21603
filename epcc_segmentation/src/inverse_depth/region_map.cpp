// SPDX-License-Identifier: BSD-3-Clause
// Moments of labelled pixels: sums along a run of a row, spread to three dimensions once a run.
#include "inverse_depth/region_map.h"

#include "inverse_depth/relabelling.h"

namespace epcc {

namespace {

/// Sums along a run of one row with the rays (a, along, 1).
struct PerspectiveRun {
  double n = 0.0, w_plain = 0.0;
  double one = 0.0, a = 0.0, aa = 0.0, w = 0.0, aw = 0.0, ww = 0.0;

  void add(double across, double /*forward*/, double value, double weight) {
    n += 1.0;
    w_plain += value;
    const double weighted_across = weight * across;
    const double weighted = weight * value;
    one += weight;
    a += weighted_across;
    aa += weighted_across * across;
    w += weighted;
    aw += weighted * across;
    ww += weighted * value;
  }
  void addTo(PlaneMoments& moments, double along) const {
    moments.n += n;
    moments.w_sum += w_plain;
    moments.w_w += ww;
    moments.rays_w += Eigen::Vector3d(aw, along * w, w);
    Eigen::Matrix3d m;
    m << aa, along * a, a, along * a, along * along * one, along * one, a, along * one, one;
    moments.rays += m;
  }
};

/// The same with the rays (a, along, f) of a spherical scan, where a^2 + f^2 = 1.
struct SphericalRun {
  PerspectiveRun across_only;
  double f = 0.0, af = 0.0, fw = 0.0;

  void add(double across, double forward, double value, double weight) {
    across_only.add(across, forward, value, weight);
    f += weight * forward;
    af += weight * across * forward;
    fw += weight * forward * value;
  }
  void addTo(PlaneMoments& moments, double along) const {
    const PerspectiveRun& s = across_only;
    moments.n += s.n;
    moments.w_sum += s.w_plain;
    moments.w_w += s.ww;
    moments.rays_w += Eigen::Vector3d(s.aw, along * s.w, fw);
    Eigen::Matrix3d m;
    m << s.aa, along * s.a, af, along * s.a, along * along * s.one, along * f, af, along * f, s.one - s.aa;
    moments.rays += m;
  }
};

template <typename Run>
void accumulateRuns(const InverseDepthImage& image, const std::vector<std::int32_t>& labels,
                    std::vector<PlaneMoments>& regions) {
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
    const float* w = image.w.data() + row * width;
    const float* weight = image.weight.data() + row * width;
    const std::int32_t* label = labels.data() + row * width;
    std::size_t column = 0;
    while (column < width) {
      const std::int32_t here = label[column];
      if (here == 0) {
        ++column;
        continue;
      }
      Run run;
      for (; column < width && label[column] == here; ++column)
        run.add(image.across[column], image.forward[column], static_cast<double>(w[column]),
                static_cast<double>(weight[column]));
      run.addTo(regions[static_cast<std::size_t>(here - 1)], image.along[row]);
    }
  }
}

}  // namespace

void RegionMap::accumulate(const InverseDepthImage& image) {
  for (auto& region : regions) region = PlaneMoments();
  if (image.planar_rows)
    accumulateRuns<PerspectiveRun>(image, labels, regions);
  else
    accumulateRuns<SphericalRun>(image, labels, regions);
}

void RegionMap::relabel(const std::vector<std::int32_t>& new_label) {
  std::size_t kept = 0;
  while (kept < new_label.size() && new_label[kept] == static_cast<std::int32_t>(kept)) ++kept;
  if (kept == new_label.size()) return;
  relabelPixels(labels.data(), labels.size(), new_label.data());
}

}  // namespace epcc
