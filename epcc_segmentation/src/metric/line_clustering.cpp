// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1 of the paper, one function a step.
#include "metric/line_clustering.h"

#include <algorithm>

namespace epcc {

void LinePrototype::fit(const Eigen::Vector2d& t) {
  statistics.add(t);
  normal = smallestEigenvector(statistics.covariance);
}

void LinePrototype::update(const Eigen::Vector2d& t) {
  const double d = distance(t);
  const double n = statistics.n + 1.0;
  variance = (n - 2.0) / (n - 1.0) * variance + d * d / n;
  fit(t);
}

void LineClustering::cluster(const ScanLine& line, ClusteredLines& result) {
  result.clear();
  begin(result);
  for (const auto& sample : line.samples) add(sample);
  finish();
  for (auto& segment : result.segments) {
    segment.a = line.lift(segment.start);
    segment.b = line.lift(segment.end);
  }
}

void LineClustering::begin(ClusteredLines& result) {
  result_ = &result;
  has_active_ = false;
  buffer_.clear();
}

void LineClustering::add(const ScanSample& sample) {
  if (has_active_ && accepts(active_, sample)) {
    active_.update(sample.t);
    takeMember(sample);
    buffer_.clear();
    return;
  }
  buffer_.push_back(sample);
  if (static_cast<int>(buffer_.size()) < parameters_.minSamples()) return;
  if (!findNewSegment() && static_cast<int>(buffer_.size()) >= parameters_.buffer_samples)
    buffer_.erase(buffer_.begin());
}

void LineClustering::finish() {
  emitSegment();
  buffer_.clear();
  result_ = nullptr;
}

// Eq. 20 with the sensor's axial noise projected on the normal.
bool LineClustering::accepts(const LinePrototype& prototype, const ScanSample& sample) const {
  const double d = prototype.distance(sample.t);
  double variance = prototype.variance;
  if (parameters_.use_sensor_noise) {
    const double q = prototype.normal.dot(sample.ray);
    variance += sample.sensor_variance * std::max(q * q, parameters_.projection_floor);
  }
  return d * d <= k_max_ * k_max_ * variance;
}

// Every start is tried; the first whose line enough later samples agree with wins.
bool LineClustering::findNewSegment() {
  const auto fit_samples = static_cast<std::size_t>(parameters_.fit_samples);
  const auto last_start = buffer_.size() - static_cast<std::size_t>(parameters_.minSamples());
  for (std::size_t start = 0; start <= last_start; ++start) {
    LinePrototype candidate;
    for (std::size_t i = start; i < start + fit_samples; ++i) candidate.statistics.add(buffer_[i].t);
    candidate.normal = smallestEigenvector(candidate.statistics.covariance);
    candidate.resetVariance();
    consistent_.clear();
    for (std::size_t i = start + fit_samples; i < buffer_.size(); ++i)
      if (accepts(candidate, buffer_[i])) consistent_.push_back(i);
    if (static_cast<int>(consistent_.size()) < parameters_.validation_samples) continue;
    startSegment(start, candidate);
    return true;
  }
  return false;
}

// The old segment goes out before the new one takes its samples from the buffer.
void LineClustering::startSegment(std::size_t start, const LinePrototype& candidate) {
  emitSegment();
  active_ = candidate;
  has_active_ = true;
  member_begin_ = static_cast<int>(result_->members.size());
  first_sample_ = buffer_[start].t;
  for (std::size_t i = start; i < start + static_cast<std::size_t>(parameters_.fit_samples); ++i)
    takeMember(buffer_[i]);
  for (const std::size_t i : consistent_) {
    active_.statistics.add(buffer_[i].t);
    takeMember(buffer_[i]);
  }
  active_.normal = smallestEigenvector(active_.statistics.covariance);
  active_.resetVariance();
  buffer_.clear();
}

void LineClustering::takeMember(const ScanSample& sample) {
  result_->members.push_back(sample.position);
  last_sample_ = sample.t;
}

void LineClustering::emitSegment() {
  if (!has_active_) return;
  has_active_ = false;
  ClusteredLine segment;
  segment.member_begin = member_begin_;
  segment.member_end = static_cast<int>(result_->members.size());
  segment.first = result_->members[static_cast<std::size_t>(member_begin_)];
  segment.last = result_->members.back();
  segment.prototype = active_;
  segment.start = active_.project(first_sample_);
  segment.end = active_.project(last_sample_);
  result_->segments.push_back(segment);
}

}  // namespace epcc
