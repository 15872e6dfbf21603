// SPDX-License-Identifier: BSD-3-Clause
// S1, sample by sample: accept, buffer, start anew, end at a gap.
// Divisions are slow: the tests are multiplied out.
#include "inverse_depth/line_growing.h"

namespace epcc {

void LineGrowing::grow(const float* w, const float* weight, const double* x, int count, std::int32_t first_id,
                       std::vector<GrownLine>& lines, std::int32_t* segment_of) {
  w_ = w;
  weight_ = weight;
  x_ = x;
  count_ = count;
  lines_ = &lines;
  segment_of_ = segment_of;
  has_active_ = false;
  buffer_.clear();
  active_id_ = first_id - 1;
  for (int i = 0; i < count; ++i) {
    if (has_active_) i = extendActive(i);
    if (i == count) break;
    segment_of[i] = -1;
    if (!(w[i] > 0.0f)) continue;
    pushOnBuffer(i);
    if (static_cast<int>(buffer_.size()) == parameters_.min_samples) startFromBuffer();
  }
  emit();
}

void LineGrowing::add(int position, LineSums& sums) const {
  sums.add(x_[position], static_cast<double>(w_[position]), static_cast<double>(weight_[position]));
}

// Adds the samples from `position` on to the active line until one is rejected or lies beyond a gap, which ends
// the line. Returns that sample's position.
int LineGrowing::extendActive(int position) {
  // Copies that the compiler may keep in registers.
  const float* w = w_;
  const double* x = x_;
  const float* weights = weight_;
  std::int32_t* segment_of = segment_of_;
  const int count = count_;
  const int reach = parameters_.max_gap_pixels + 1;
  const double k2 = k_max_ * k_max_;
  LineSums sums = active_.sums;
  int last = active_.last;
  int i = position;
  for (; i < count; ++i) {
    const auto value = static_cast<double>(w[i]);
    if (!(value > 0.0)) {
      segment_of[i] = -1;
      continue;
    }
    if (i - last > reach) break;
    const auto weight = static_cast<double>(weights[i]);
    // |w - mean_w - slope (x - mean_x)| <= k_max sigma_w, times one * (one Sxx) / sigma_w.
    const double sxx = sums.scaledSxx();
    const double residual = (value * sums.one - sums.w) * sxx - (x[i] * sums.one - sums.x) * sums.scaledSxw();
    const double scale = sums.one * sxx;
    if (!(residual * residual * weight <= k2 * (scale * scale))) break;
    sums.add(x[i], value, weight);
    segment_of[i] = active_id_;
    last = i;
  }
  if (last != active_.last) buffer_.clear();
  active_.sums = sums;
  active_.last = last;
  if (i < count && i - last > reach) emit();
  return i;
}

void LineGrowing::pushOnBuffer(int position) {
  if (!buffer_.empty() && position - buffer_.back() > parameters_.max_gap_pixels + 1) buffer_.clear();
  if (static_cast<int>(buffer_.size()) == parameters_.min_samples) buffer_.erase(buffer_.begin());
  buffer_.push_back(position);
}

// The last rejected samples start a line of their own if they lie on one.
void LineGrowing::startFromBuffer() {
  LineSums sums;
  for (const int position : buffer_) add(position, sums);
  const double sxx = sums.scaledSxx();
  const double sxw = sums.scaledSxw();
  if (!(sxx > 1e-12 * sums.one * sums.one)) return;  // one point over and over is no line
  // RSS <= (n - 2) k_max^2, times one * (one Sxx).
  const double limit = (sums.n - 2.0) * k_max_ * k_max_;
  if (sums.scaledSww() * sxx - sxw * sxw > limit * sums.one * sxx) return;
  emit();
  has_active_ = true;
  ++active_id_;
  active_.first = buffer_.front();
  active_.last = buffer_.back();
  active_.sums = sums;
  for (const int position : buffer_) segment_of_[position] = active_id_;
  buffer_.clear();
}

void LineGrowing::emit() {
  if (has_active_) lines_->push_back(active_);
  has_active_ = false;
}

}  // namespace epcc
