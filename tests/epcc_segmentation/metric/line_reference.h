// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1 as plain loops, one scan line at a time and every start tried anew: in the kernel's single precision,
// whose bits must be the same, and in double precision, whose labels must be nearly the same.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "metric/line_clustering.h"

namespace epcc::test {

template <typename T>
struct ReferenceSample {
  T t1, t2, ray1, ray2, variance;
  int row;
};

template <typename T>
struct ReferencePrototype {
  T n = 0, mean1 = 0, mean2 = 0, s11 = 0, s22 = 0, s12 = 0, residuals = 0, normal1 = 0, normal2 = 0;

  T normalSquared() const { return normal1 * normal1 + normal2 * normal2; }
  T distance(const ReferenceSample<T>& s) const { return normal1 * (s.t1 - mean1) + normal2 * (s.t2 - mean2); }
  void findNormal() {
    const T half = T(0.5) * (s11 - s22);
    const T large = std::max(std::abs(half) + std::sqrt(half * half + s12 * s12), T(1e-12f));
    normal1 = half > 0 ? -s12 : large;
    normal2 = half > 0 ? large : -s12;
  }
  void take(const ReferenceSample<T>& s, T share, T grown) {
    const T dx = s.t1 - mean1;
    const T dy = s.t2 - mean2;
    n += 1;
    mean1 += dx * share;
    mean2 += dy * share;
    s11 += dx * grown * dx;
    s12 += dx * grown * dy;
    s22 += dy * grown * dy;
  }
  void add(const ReferenceSample<T>& s) {  // Eqs. 12, 13
    const T share = T(1) / (n + 1);
    take(s, share, n * share);
  }
  void update(const ReferenceSample<T>& s) {  // and Eq. 11
    const T d = distance(s);
    residuals += d * d / normalSquared() * (n * (T(1) / (n + 1)));
    add(s);
    findNormal();
  }
  void finishFit() {
    findNormal();
    const T along1 = s11 * normal1 + s12 * normal2;
    const T along2 = s12 * normal1 + s22 * normal2;
    residuals = std::max((normal1 * along1 + normal2 * along2) / normalSquared(), T(0));
  }
};

template <typename T>
struct ReferenceSegment {
  ReferencePrototype<T> prototype;
  std::vector<ReferenceSample<T>> members;
};

/// Steps 1 to 4.
template <typename T>
class ReferenceClustering {
 public:
  explicit ReferenceClustering(const ClusteringRule& rule) : rule_(rule) {}

  std::vector<ReferenceSegment<T>> cluster(const std::vector<ReferenceSample<T>>& line) {
    segments_.clear();
    buffer_.clear();
    for (const auto& sample : line) add(sample);
    return segments_;
  }

 private:
  bool accepts(const ReferencePrototype<T>& p, const ReferenceSample<T>& s) const {
    const T d = p.distance(s);
    const T q = p.normal1 * s.ray1 + p.normal2 * s.ray2;
    const T across = std::max(q * q, static_cast<T>(rule_.projection_floor) * p.normalSquared());
    const T spread = p.residuals * p.normalSquared() + (p.n - 1) * (s.variance * across);
    return d * d * (p.n - 1) <= static_cast<T>(rule_.k_max_squared) * spread;
  }
  void add(const ReferenceSample<T>& s) {
    if (!segments_.empty() && accepts(segments_.back().prototype, s)) {
      segments_.back().prototype.update(s);
      segments_.back().members.push_back(s);
      buffer_.clear();
      return;
    }
    buffer_.push_back(s);
    const int size = static_cast<int>(buffer_.size());
    for (int start = 0; start + rule_.minSamples() <= size; ++start)
      if (startsAt(start)) {
        buffer_.clear();
        return;
      }
    if (size >= rule_.minSamples() && size >= rule_.buffer_samples) buffer_.erase(buffer_.begin());
  }
  bool startsAt(int start) {
    ReferenceSegment<T> segment;
    ReferencePrototype<T>& p = segment.prototype;
    const auto begin = buffer_.begin() + start;
    segment.members.assign(begin, begin + rule_.fit_samples);
    for (const auto& s : segment.members) p.add(s);
    p.finishFit();
    const ReferencePrototype<T> candidate = p;
    for (auto s = begin + rule_.fit_samples; s != buffer_.end(); ++s)
      if (accepts(candidate, *s)) segment.members.push_back(*s);
    if (static_cast<int>(segment.members.size()) < rule_.minSamples()) return false;
    for (auto s = segment.members.begin() + rule_.fit_samples; s != segment.members.end(); ++s) p.add(*s);
    p.finishFit();
    segments_.push_back(segment);
    return true;
  }

  ClusteringRule rule_;
  std::vector<ReferenceSegment<T>> segments_;
  std::vector<ReferenceSample<T>> buffer_;
};

inline float referenceVariance(const SensorVariance& v, float z) {
  const float spread = std::max((v.k0 * z + v.k1) * z + v.k2, 0.0f);
  return std::min(std::max(spread * spread + v.floor, v.smallest), v.largest);
}

/// The measured samples of a view's column as the kernel has them.
inline std::vector<ReferenceSample<float>> referenceLine(const DepthFrame& view, const ClusteringRule& rule,
                                                         int column) {
  std::vector<ReferenceSample<float>> line;
  float slope = 0.0f;
  if (view.isPinhole())
    for (int c = 0; c < view.width(); ++c)
      slope = std::max(slope, static_cast<float>(std::sqrt(1.0 + view.pinholeAcross(c) * view.pinholeAcross(c))));
  if (view.isPinhole())
    for (int r = 0; r < view.height(); ++r) slope = std::max(slope, std::abs(static_cast<float>(view.pinholeAlong(r))));
  const auto add = [&](float t1, float t2, float ray1, float ray2, float depth, int row) {
    const bool is_near = view.isPinhole() ? depth <= farthestDepth(slope) : std::max(t1, std::abs(t2)) <= kFarthest;
    if (t1 > 0.0f && is_near) line.push_back({t1, t2, ray1, ray2, referenceVariance(rule.variance, depth), row});
  };
  Eigen::Vector3d p;
  for (int row = 0; row < view.height(); ++row) {
    if (!view.scanPoint(row, column, p) || p.cwiseAbs().maxCoeff() > static_cast<double>(kFarthest)) continue;
    const auto z = static_cast<float>(p.z());
    if (view.isPinhole()) {
      const double u = view.pinholeAcross(column);
      const auto secant = static_cast<float>(std::sqrt(1.0 + u * u));
      const auto v = static_cast<float>(view.pinholeAlong(row));
      add(z * secant, z * v, secant, v, z, row);
      continue;
    }
    const auto x = static_cast<float>(p.x());
    const auto y = static_cast<float>(p.y());
    const float squared = x * x + z * z;
    const float t1 = std::sqrt(squared);
    const float depth = isPerspective(view.projection()) ? z : std::sqrt(squared + y * y);
    const float inverse = 1.0f / depth;
    add(t1, y, t1 * inverse, y * inverse, depth, row);
  }
  return line;
}

/// The same in double precision.
inline std::vector<ReferenceSample<double>> preciseLine(const DepthFrame& view, const SensorModel& sensor, int column) {
  std::vector<ReferenceSample<double>> line;
  Eigen::Vector3d p;
  for (int row = 0; row < view.height(); ++row) {
    if (!view.scanPoint(row, column, p)) continue;
    const double t1 = std::sqrt(p.x() * p.x() + p.z() * p.z());
    const double depth = view.measuredDepth(p);
    if (t1 > 0.0) line.push_back({t1, p.y(), t1 / depth, p.y() / depth, sensor.varianceZ(depth), row});
  }
  return line;
}

}  // namespace epcc::test
