// SPDX-License-Identifier: BSD-3-Clause
// The blocks of all frames together, for both sizes of blocks, for which one is needed shows at the end.
#include <array>

#include "epcc_segmentation/sensor_estimation.h"
#include "geometry/sensor_cloud.h"
#include "sensor/image_estimation.h"
#include "sensor/residual_correlation.h"

namespace epcc {

namespace {

/// Blocks of one size.
struct OfSize {
  explicit OfSize(int size) : correlation(size) { estimation.begin(size); }
  ImageEstimation estimation;
  ResidualCorrelation correlation;
};

}  // namespace

struct SensorPool::Pool {
  SensorCloud cloud;
  InverseDepthImage image;  // the last one
  std::size_t frames = 0;
  std::vector<OfSize> sizes;  // that which is preferred first
};

SensorPool::SensorPool() : pool_(std::make_unique<Pool>()) {}
SensorPool::~SensorPool() = default;
SensorPool::SensorPool(SensorPool&&) noexcept = default;
SensorPool& SensorPool::operator=(SensorPool&&) noexcept = default;

bool SensorPool::add(const DepthFrame& any_frame) {
  if (any_frame.empty()) return false;
  Pool& pool = *pool_;
  const DepthFrame frame = inSensorFrame(any_frame, pool.cloud);
  if (pool.frames == 0) {
    const int first = ImageEstimation::blockSize(frame.width(), frame.height());
    for (const int size : {first, ImageEstimation::otherSize(first)}) pool.sizes.emplace_back(size);
  } else if (frame.width() != pool.image.width || frame.height() != pool.image.height) {
    return false;
  }
  pool.image.read(frame);
  ++pool.frames;
  for (OfSize& blocks : pool.sizes) {
    blocks.estimation.measure(pool.image, Turn());
    blocks.correlation.add(pool.image);
  }
  return true;
}

std::size_t SensorPool::frames() const {
  return pool_->frames;
}

SensorMeasurement SensorPool::measure() const {
  SensorMeasurement result;
  for (OfSize& blocks : pool_->sizes) {
    result = blocks.estimation.describe(pool_->image);
    if (result.estimate.blocks == 0) continue;
    result.correlation = blocks.correlation.measured();
    result.correlation_fit = blocks.correlation.expected(result.grain, result.blotches, result.estimate.blotch_length);
    break;
  }
  return result;
}

}  // namespace epcc
