// SPDX-License-Identifier: BSD-3-Clause
// The model of a stream: medians and a majority over its last frames.
#include <algorithm>
#include <array>
#include <vector>

#include "epcc_segmentation/sensor_estimation.h"
#include "sensor/image_estimation.h"
#include "sensor/quantile.h"

namespace epcc {

SensorEstimator::SensorEstimator(std::size_t memory, std::size_t interval)
    : memory_(std::max<std::size_t>(memory, 1)), interval_(std::max<std::size_t>(interval, 1)) {}

void SensorEstimator::reset() {
  estimates_.clear();
  next_ = 0;
  skipped_ = 0;
}

bool SensorEstimator::isDue(int width, int height) const {
  if (width != width_ || height != height_) return true;
  return estimates_.size() < memory_ || skipped_ + 1 >= interval_;
}

SensorEstimate SensorEstimator::update(const DepthFrame& frame) {
  InverseDepthImage image;
  image.width = frame.width();
  image.height = frame.height();
  if (isDue(frame.width(), frame.height())) image.read(frame);
  return update(image);
}

SensorEstimate SensorEstimator::update(const InverseDepthImage& image) {
  const bool due = isDue(image.width, image.height);
  if (image.width != width_ || image.height != height_) reset();
  width_ = image.width;
  height_ = image.height;
  skipped_ = due ? 0 : skipped_ + 1;
  return due ? take(estimateSensor(image)) : stream_;
}

SensorEstimate SensorEstimator::take(const SensorEstimate& latest) {
  if (latest.blocks > 0) {
    if (estimates_.size() < memory_)
      estimates_.push_back(latest);
    else
      estimates_[next_++ % memory_] = latest;
  }
  stream_ = estimates_.empty() ? latest : summary(latest);
  return stream_;
}

/// Of what is remembered; never empty.
SensorEstimate SensorEstimator::summary(SensorEstimate stream) const {
  std::array<int, 3> votes{};
  std::vector<double> a, b;
  stream.blocks = 0;
  for (const auto& estimate : estimates_) {
    ++votes[static_cast<std::size_t>(estimate.noise_class)];
    a.push_back(estimate.a);
    b.push_back(estimate.b);
    stream.blocks += estimate.blocks;
  }
  stream.noise_class = static_cast<NoiseClass>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  std::vector<double> lengths;
  for (const auto& estimate : estimates_)
    if (estimate.noise_class == stream.noise_class) lengths.push_back(estimate.correlation_length);
  stream.correlation_length = quantile(lengths, 0.5);
  stream.a = quantile(a, 0.5);
  stream.b = quantile(b, 0.5);
  return stream;
}

}  // namespace epcc
