// SPDX-License-Identifier: BSD-3-Clause
// S1, sample by sample: accept, buffer, start anew, end at a gap.
#include "inverse_depth/line_growing.h"

#include <algorithm>

namespace epcc {

void LineGrowing::grow(const float* w, const double* x, const double* scale, int count, const InverseDepthNoise& noise,
                       std::int32_t first_id, std::vector<GrownLine>& lines, std::int32_t* segment_of) {
  lines_ = &lines;
  segment_of_ = segment_of;
  has_active_ = false;
  buffer_.clear();
  active_id_ = first_id - 1;
  std::fill(segment_of, segment_of + count, -1);
  for (int i = 0; i < count; ++i) {
    if (!(w[i] > 0.0f)) continue;
    const double value = static_cast<double>(w[i]);
    double variance = noise.variance(value);
    if (scale != nullptr) variance = noise.variance(value * scale[i]) / (scale[i] * scale[i]);
    const Sample sample{i, x[i], value, variance};

    if (!buffer_.empty() && i - buffer_.back().position > parameters_.max_gap_pixels + 1) buffer_.clear();
    if (has_active_ && i - active_.last > parameters_.max_gap_pixels + 1) emit();
    if (has_active_ && accepts(sample)) {
      addToActive(sample);
      buffer_.clear();
      continue;
    }
    buffer_.push_back(sample);
    if (static_cast<int>(buffer_.size()) > parameters_.min_samples) buffer_.erase(buffer_.begin());
    if (static_cast<int>(buffer_.size()) == parameters_.min_samples) startFromBuffer();
  }
  emit();
}

bool LineGrowing::accepts(const Sample& sample) const {
  const double residual = sample.w - mean_w_ - slope_ * (sample.x - mean_x_);
  return residual * residual <= parameters_.k_max * parameters_.k_max * sample.variance;
}

void LineGrowing::addToActive(const Sample& sample) {
  active_.sums.add(sample.x, sample.w, sample.variance);
  active_.last = sample.position;
  segment_of_[sample.position] = active_id_;
  mean_x_ = active_.sums.meanX();
  mean_w_ = active_.sums.meanW();
  slope_ = active_.sums.slope();
}

// The last rejected samples start a line of their own if they lie on one.
bool LineGrowing::startFromBuffer() {
  LineSums sums;
  for (const Sample& sample : buffer_) sums.add(sample.x, sample.w, sample.variance);
  if (!(sums.sxx() > 1e-12 * sums.one)) return false;  // one point over and over is no line
  if (sums.rss() > (sums.n - 2.0) * parameters_.k_max * parameters_.k_max) return false;
  emit();
  has_active_ = true;
  ++active_id_;
  active_ = GrownLine();
  active_.first = buffer_.front().position;
  for (const Sample& sample : buffer_) addToActive(sample);
  buffer_.clear();
  return true;
}

void LineGrowing::emit() {
  if (has_active_) lines_->push_back(active_);
  has_active_ = false;
}

}  // namespace epcc
