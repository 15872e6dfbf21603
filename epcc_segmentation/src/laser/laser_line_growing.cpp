// SPDX-License-Identifier: BSD-3-Clause
// A sample belongs to the active line, or waits in the buffer until there are enough for a new one.
#include "laser/laser_line_growing.h"

#include <algorithm>

namespace epcc {
namespace {

constexpr int kCornerSamples = 2;  // that the line before a corner may take of the line behind it
// Of a line, sigma^2: below, a few samples that agree by chance would reject the next; beyond, corners would count as
// noise.
constexpr double kMostOwnVariance = 3.0;

/// The active line and a candidate.
class Prototype {
 public:
  Prototype(const std::vector<LaserSample>& samples, const LaserLineParameters& parameters)
      : samples_(&samples), parameters_(&parameters) {}

  bool empty() const { return grown_.members.empty(); }
  const GrownLaserLine& grown() const { return grown_; }

  /// Starts anew with these samples; false if they are on no line.
  bool start(std::vector<int>::const_iterator first, std::vector<int>::const_iterator last) {
    grown_.members.assign(first, last);
    sums_ = RangeLineSums();
    for (const int i : grown_.members) sums_.add((*samples_)[i]);
    if (!sums_.solve(grown_.line)) return false;
    const int freedom = sums_.n() - 2;
    own_variance_ = sums_.squaredErrors(grown_.line) / freedom;
    if (own_variance_ > parameters_->k_max * parameters_->k_max) return false;
    for (std::size_t i = 1; i < grown_.members.size(); ++i)
      if (!isWithinGap(grown_.line, sample(i - 1), sample(i), parameters_->max_gap)) return false;
    return true;
  }

  /// Eq. 20, with the variance of the prediction, and no larger gap than allowed.
  bool accepts(int i) const {
    RangeError error;
    const LaserSample& candidate = (*samples_)[i];
    if (!rangeError(grown_.line, candidate, error)) return false;
    const double own = std::clamp(own_variance_, 1.0, kMostOwnVariance);
    const double variance = error.variance * (1.0 + own) + grown_.line.rangeVariance(candidate.direction);
    return error.squared <= parameters_->k_max * parameters_->k_max * variance &&
           isWithinGap(grown_.line, (*samples_)[grown_.members.back()], candidate, parameters_->max_gap);
  }

  /// Adds a sample: Eq. 11 in units of sigma, and the line of least squares.
  void add(int i) {
    RangeError error;
    if (!rangeError(grown_.line, (*samples_)[i], error)) return;
    const double n = sums_.n() + 1.0;
    own_variance_ = (n - 2.0) / (n - 1.0) * own_variance_ + error.squared / error.variance / n;
    sums_.add((*samples_)[i]);
    grown_.members.push_back(i);
    sums_.solve(grown_.line);
  }

 private:
  const LaserSample& sample(std::size_t member) const { return (*samples_)[grown_.members[member]]; }

  const std::vector<LaserSample>* samples_;
  const LaserLineParameters* parameters_;
  GrownLaserLine grown_;
  RangeLineSums sums_;
  double own_variance_ = 0.0;  // sigma^2
};

}  // namespace

bool isWithinGap(const RangeLine& line, const LaserSample& from, const LaserSample& to, double max_gap) {
  if (std::abs(to.beam - from.beam) <= 1) return true;
  const double a = line.range(from.direction), b = line.range(to.direction);
  if (!(a > 0.0) || !(b > 0.0)) return false;
  return (a * from.direction - b * to.direction).norm() <= max_gap;
}

std::vector<GrownLaserLine> growLaserLines(const std::vector<LaserSample>& samples,
                                           const LaserLineParameters& parameters) {
  const int length = std::max(5, parameters.min_points - kCornerSamples);
  const std::size_t most_waiting = 2 * static_cast<std::size_t>(length);
  std::vector<GrownLaserLine> result;
  std::vector<int> buffer;
  Prototype active(samples, parameters);
  for (int i = 0; i < static_cast<int>(samples.size()); ++i) {
    if (!active.empty() && active.accepts(i)) {
      active.add(i);
      buffer.clear();
      continue;
    }
    buffer.push_back(i);
    if (static_cast<int>(buffer.size()) < length) continue;
    Prototype candidate(samples, parameters);
    // Windows that end earlier were tried when they were the last.
    if (candidate.start(buffer.end() - length, buffer.end())) {
      if (!active.empty()) result.push_back(active.grown());
      buffer.clear();
      active = candidate;
    } else if (buffer.size() == most_waiting) {
      buffer.erase(buffer.begin());
    }
  }
  if (!active.empty()) result.push_back(active.grown());
  return result;
}

}  // namespace epcc
