// SPDX-License-Identifier: BSD-3-Clause
// Beams that return nothing are skipped; they end nothing.
#include "laser/laser_samples.h"

#include <algorithm>

namespace epcc {
namespace {

/// Error of the middle of three samples from the line through the other two, in sigma.
double bend(const LaserSample& before, const LaserSample& middle, const LaserSample& after) {
  const Eigen::Vector2d a = before.point(), b = after.point();
  // The beam meets the line through both where cross(direction, b - a) is not 0.
  const double across = middle.direction.x() * (b - a).y() - middle.direction.y() * (b - a).x();
  const double range = (a.x() * b.y() - a.y() * b.x()) / across;
  if (!std::isfinite(range)) return std::numeric_limits<double>::max();
  return std::abs(range - middle.range) / middle.sigma;
}

/// Place of the sample that is least on a line with those beside it.
std::size_t sharpestCorner(const std::vector<LaserSample>& samples) {
  const std::size_t n = samples.size();
  constexpr std::size_t kApart = 3;  // beams: neighbours alone are as far apart as their noise
  if (n < 2 * kApart + 1) return 0;
  std::size_t sharpest = 0;
  double largest = -1.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double value = bend(samples[(i + n - kApart) % n], samples[i], samples[(i + kApart) % n]);
    if (value <= largest) continue;
    largest = value;
    sharpest = i;
  }
  return sharpest;
}

}  // namespace

Eigen::Vector2d beamDirection(const LaserScan& scan, int beam) {
  const double angle = scan.angle(static_cast<std::size_t>(beam));
  return {std::cos(angle), std::sin(angle)};
}

std::vector<LaserSample> readSamples(const LaserScan& scan, const SensorModel& noise, bool circle) {
  std::vector<LaserSample> samples;
  samples.reserve(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (!scan.hasReturn(i)) continue;
    const int beam = static_cast<int>(i);
    samples.push_back({beamDirection(scan, beam), scan.ranges[i], noise.sigmaZ(scan.ranges[i]), beam});
  }
  if (circle)
    std::rotate(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(sharpestCorner(samples)), samples.end());
  return samples;
}

}  // namespace epcc
