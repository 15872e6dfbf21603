// SPDX-License-Identifier: BSD-3-Clause
// The first scan lines of a stream, kept until the sensor is measured on them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/sensor_estimation.h"
#include "epcc_segmentation/stream_geometry.h"
#include "stream/given_line.h"

namespace epcc {

/// Keeps up to `capacity` scan lines, lost ones among them.
class MeasuredStretch {
 public:
  void begin(const StreamGeometry& geometry, int capacity);
  /// Whether a line of this index lies in the stretch.
  bool takes(std::int64_t index) const { return lines_.empty() || index - lines_.front().index < capacity_; }
  void add(const GivenLine& line);
  /// Of all lines side by side, as a frame; blocks = 0 if nothing flat was found.
  SensorEstimate measure() const;
  std::size_t size() const { return lines_.size(); }
  GivenLine line(std::size_t i) const;
  /// Gives the memory back.
  void clear();

 private:
  bool isCamera() const { return geometry_.kind() < StreamGeometry::Kind::Scanner; }
  std::size_t valuesOfSample() const { return geometry_.kind() == StreamGeometry::Kind::Points ? 3 : 1; }
  const float* sample(std::size_t line, std::size_t i) const {
    return values_.data() + (line * height_ + i) * valuesOfSample();
  }
  SensorEstimate measureImage(std::size_t span) const;
  SensorEstimate measureCloud(std::size_t span) const;

  StreamGeometry geometry_ = StreamGeometry::points(1, Projection::Perspective);
  std::int64_t capacity_ = 0;
  std::size_t height_ = 0;
  std::vector<GivenLine> lines_;
  std::vector<float> values_;
};

}  // namespace epcc
