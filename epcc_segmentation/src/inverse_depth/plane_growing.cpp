// SPDX-License-Identifier: BSD-3-Clause
// S2: overlap and coplanarity with the previous scan line's planes.
#include "inverse_depth/plane_growing.h"

#include <algorithm>

namespace epcc {

PlaneMoments segmentMoments(const ScanLineRays& rays, const LineSums& s) {
  PlaneMoments moments;
  const Eigen::Matrix3d cross = rays.base * rays.axis.transpose();
  moments.n = s.n;
  moments.w_sum = s.n * s.meanW();
  moments.rays = s.one * rays.base * rays.base.transpose() + s.x * (cross + cross.transpose()) +
                 s.xx * rays.axis * rays.axis.transpose();
  moments.rays_w = s.w * rays.base + s.xw * rays.axis;
  moments.w_w = s.ww;
  return moments;
}

void PlaneGrowing::configure(const InverseDepthParameters& parameters, const SensorModel& sensor) {
  k_max_ = parameters.plane_k_max;
  parameters_ = parameters.expert.planes;
  pixels_per_sample_ = sensor.pixelsPerSample();
  pixels_per_line_sample_ = sensor.pixelsPerLineSample();
  correlation_length_ = sensor.correlationLength();
}

void PlaneGrowing::begin(double pixel_pitch) {
  sample_spread_ = std::pow(correlation_length_ * pixel_pitch, 2);
  previous_.clear();
  previous_begin_ = 0;
  plane_of_.clear();
  planes_.clear();
}

void PlaneGrowing::addLine(const ScanLineRays& rays, const GrownLine* lines, std::size_t count) {
  const std::size_t begin = plane_of_.size();
  for (std::size_t k = 0; k < count; ++k) {
    const GrownLine& line = lines[k];
    double best_mismatch = k_max_ * k_max_;
    int best = -1;
    for (std::size_t j = 0; j < previous_.size(); ++j) {
      const int overlap = std::min(line.last, previous_[j].last) - std::max(line.first, previous_[j].first) + 1;
      const int shorter = std::min(line.last - line.first, previous_[j].last - previous_[j].first) + 1;
      if (overlap < parameters_.min_overlap_pixels || 2 * overlap < shorter) continue;
      const int plane = plane_of_[previous_begin_ + j];
      if (plane == best) continue;
      const double m = mismatch(planes_[static_cast<std::size_t>(plane)], rays, line);
      if (m >= best_mismatch) continue;
      best_mismatch = m;
      best = plane;
    }
    if (best < 0) {
      best = static_cast<int>(planes_.size());
      planes_.emplace_back();
      const double w = line.sums.meanW();
      planes_.back().ridge = pixels_per_sample_ / (4.0 * w * w);  // a weak prior: slopes up to about 4
    }
    GrownPlane& plane = planes_[static_cast<std::size_t>(best)];
    plane.moments += segmentMoments(rays, line.sums);
    plane.estimate = plane.moments.fit(plane.ridge);
    ++plane.segments;
    plane_of_.push_back(best);
  }
  previous_.assign(lines, lines + count);
  previous_begin_ = begin;
}

// T: the squared difference of line and plane at the ends of an equivalent uniform line, over its variance.
double PlaneGrowing::mismatch(const GrownPlane& plane, const ScanLineRays& rays, const GrownLine& line) const {
  const LineSums& s = line.sums;
  const double sigma2 = s.meanVariance();
  const double spread = s.spread();
  const double h = std::sqrt(3.0 * spread / s.n);
  const double v0 = sigma2 * std::min(1.0, pixels_per_line_sample_ / s.n);
  const double v1 = sigma2 / (spread / pixels_per_line_sample_ + sample_spread_);
  const double mean_x = s.meanX();
  const double mean_w = s.meanW();
  const double slope = s.slope();
  double worst = 0.0;
  for (const double offset : {-h, h}) {
    const Eigen::Vector3d r = rays.base + (mean_x + offset) * rays.axis;
    const double delta = mean_w + slope * offset - plane.estimate.at(r);
    const double prediction = pixels_per_sample_ * r.dot(plane.estimate.inverse * r) + v0 + v1 * h * h;
    const double variance = sigma2 + std::min(prediction, parameters_.max_prediction * sigma2);
    worst = std::max(worst, delta * delta / variance);
  }
  return worst;
}

}  // namespace epcc
