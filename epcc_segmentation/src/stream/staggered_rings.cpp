// SPDX-License-Identifier: BSD-3-Clause
// Each ring of a column goes to the scan line of its own azimuth, as a point with the exact one.
#include "stream/staggered_rings.h"

#include <cmath>
#include <limits>

namespace epcc {

namespace {
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
}  // namespace

void StaggeredRings::begin(const StreamGeometry& geometry) {
  azimuth_step_ = geometry.azimuthStep();
  for (auto* values : {&cosine_, &sine_, &cosine_ahead_, &sine_left_}) values->clear();
  shift_.clear();
  lines_.clear();
  next_ = end_ = 0;
  if (!geometry.isStaggered()) return;
  for (std::size_t ring = 0; ring < geometry.elevations().size(); ++ring) {
    cosine_.push_back(std::cos(geometry.elevations()[ring]));
    sine_.push_back(std::sin(geometry.elevations()[ring]));
    cosine_ahead_.push_back(std::cos(geometry.ringAzimuths()[ring]));
    sine_left_.push_back(std::sin(geometry.ringAzimuths()[ring]));
    shift_.push_back(geometry.ringShift(static_cast<int>(ring)));
  }
  const auto [least, most] = std::minmax_element(shift_.begin(), shift_.end());
  least_ = *least;
  most_ = *most;
  lines_.resize(static_cast<std::size_t>(most_ - least_) + 1);
  points_.resize(lines_.size() * 3 * shift_.size());
  for (std::size_t at = 0; at < lines_.size(); ++at) clear(at);
}

void StaggeredRings::clear(std::size_t place) {
  lines_[place] = {false, kUnknown};
  std::fill_n(points(place), 3 * shift_.size(), std::numeric_limits<float>::quiet_NaN());
}

void StaggeredRings::write(const GivenLine& column) {
  end_ = column.index - least_ + 1;
  // A line whose own column came has that one's azimuth, else one in whole steps from its first column's.
  if (least_ <= 0 && most_ >= 0) lines_[place(column.index)].azimuth = column.azimuth;
  const double ahead = std::cos(column.azimuth), left = std::sin(column.azimuth);
  const std::size_t last = place(column.index - least_);
  const float* value = column.values;
  for (std::size_t ring = 0; ring < shift_.size(); ++ring, value += column.stride) {
    const auto before = static_cast<std::size_t>(shift_[ring] - least_);
    const std::size_t at = last >= before ? last - before : last + lines_.size() - before;
    Line& line = lines_[at];
    line.has_column = true;
    if (std::isnan(line.azimuth)) line.azimuth = column.azimuth - shift_[ring] * azimuth_step_;
    if (!(*value > 0.0f)) continue;
    const double level = static_cast<double>(*value) * cosine_[ring];
    float* point = points(at) + 3 * ring;
    point[0] = static_cast<float>(level * (ahead * cosine_ahead_[ring] - left * sine_left_[ring]));
    point[1] = static_cast<float>(level * (left * cosine_ahead_[ring] + ahead * sine_left_[ring]));
    point[2] = static_cast<float>(static_cast<double>(*value) * sine_[ring]);
  }
}

}  // namespace epcc
