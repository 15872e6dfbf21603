// SPDX-License-Identifier: BSD-3-Clause
// Scan lines side by side are a frame of their own, which the sensor is measured on.
#include "stream/measured_stretch.h"

#include <algorithm>
#include <cmath>

namespace epcc {

void MeasuredStretch::begin(const StreamGeometry& geometry, int capacity) {
  geometry_ = geometry;
  capacity_ = capacity;
  height_ = static_cast<std::size_t>(geometry.height());
  clear();
}

void MeasuredStretch::clear() {
  lines_.clear();
  std::vector<float>().swap(values_);
}

void MeasuredStretch::add(const GivenLine& line) {
  const float* from = line.values;
  for (std::size_t i = 0; i < height_; ++i, from += line.stride)
    values_.insert(values_.end(), from, from + valuesOfSample());
  lines_.push_back(line);
}

GivenLine MeasuredStretch::line(std::size_t i) const {
  GivenLine line = lines_[i];
  line.values = sample(i, 0);
  line.stride = static_cast<std::ptrdiff_t>(valuesOfSample());
  return line;
}

SensorEstimate MeasuredStretch::measure() const {
  if (lines_.empty()) return {};
  const auto span = static_cast<std::size_t>(lines_.back().index - lines_.front().index) + 1;
  return isCamera() ? measureImage(span) : measureCloud(span);
}

SensorEstimate MeasuredStretch::measureImage(std::size_t span) const {
  const bool columns = geometry_.kind() == StreamGeometry::Kind::CameraColumns;
  PinholeCamera camera = geometry_.camera();
  (columns ? camera.width : camera.height) = static_cast<int>(span);
  (columns ? camera.cx : camera.cy) -= static_cast<double>(lines_.front().index);
  std::vector<float> depth(span * height_, 0.0f);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto place = static_cast<std::size_t>(lines_[i].index - lines_.front().index);
    for (std::size_t k = 0; k < height_; ++k) depth[columns ? k * span + place : place * height_ + k] = *sample(i, k);
  }
  return estimateSensor(DepthFrame::fromDepth(depth.data(), camera));
}

SensorEstimate MeasuredStretch::measureCloud(std::size_t span) const {
  std::vector<float> xyz(3 * span * height_, NAN);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto place = static_cast<std::size_t>(lines_[i].index - lines_.front().index);
    for (std::size_t k = 0; k < height_; ++k) {
      float* point = xyz.data() + 3 * (k * span + place);
      const float* value = sample(i, k);
      if (geometry_.kind() == StreamGeometry::Kind::Points) {
        std::copy(value, value + 3, point);
      } else if (*value > 0.0f) {
        const auto level = static_cast<double>(*value) * std::cos(geometry_.elevations()[k]);
        point[0] = static_cast<float>(level * std::cos(lines_[i].azimuth));
        point[1] = static_cast<float>(level * std::sin(lines_[i].azimuth));
        point[2] = static_cast<float>(static_cast<double>(*value) * std::sin(geometry_.elevations()[k]));
      }
    }
  }
  const int width = static_cast<int>(span), height = static_cast<int>(height_);
  return estimateSensor(DepthFrame::fromPoints(xyz.data(), 3, width, height, geometry_.projection()));
}

}  // namespace epcc
