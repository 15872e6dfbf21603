// SPDX-License-Identifier: BSD-3-Clause
// The blocks of all frames together, for both sizes of blocks, for which one is needed shows at the end.
#include <array>

#include "epcc_segmentation/sensor_estimation.h"
#include "geometry/sensor_cloud.h"
#include "inverse_depth/scattered_pixels.h"
#include "sensor/image_estimation.h"
#include "sensor/residual_correlation.h"

namespace epcc {

struct SensorPool::Pool {
  /// Blocks of one size.
  struct OfSize {
    explicit OfSize(int size) : correlation(size) { estimation.begin(size); }
    ImageEstimation estimation;
    ResidualCorrelation correlation;
  };

  int width = 0;
  int height = 0;
  SensorCloud cloud;
  InverseDepthImage image;  // the last one
  ScatteredPixels scattered;
  InverseDepthImage first;  // as it was measured
  std::size_t frames = 0;
  std::vector<OfSize> sizes;  // that which is preferred first

  void begin(const DepthFrame& frame, const InverseDepthImage& as_measured) {
    width = frame.width();
    height = frame.height();
    first = as_measured;
    const int preferred = ImageEstimation::blockSize(first.width, first.height);
    for (const int size : {preferred, ImageEstimation::otherSize(preferred)}) sizes.emplace_back(size);
  }
};

SensorPool::SensorPool() : pool_(std::make_unique<Pool>()) {}
SensorPool::~SensorPool() = default;
SensorPool::SensorPool(SensorPool&&) noexcept = default;
SensorPool& SensorPool::operator=(SensorPool&&) noexcept = default;

bool SensorPool::add(const DepthFrame& any_frame) {
  if (any_frame.empty()) return false;
  Pool& pool = *pool_;
  const DepthFrame frame = inSensorFrame(any_frame, pool.cloud);
  if (pool.frames > 0 && (frame.width() != pool.width || frame.height() != pool.height)) return false;
  pool.image.read(frame);
  const InverseDepthImage& image = pool.scattered.measuredForm(pool.image);
  if (pool.frames == 0)
    pool.begin(frame, image);
  else if (!(image.steps == pool.first.steps))
    return false;
  ++pool.frames;
  for (Pool::OfSize& blocks : pool.sizes) {
    blocks.estimation.measure(image, Turn());
    blocks.correlation.add(image);
  }
  return true;
}

std::size_t SensorPool::frames() const {
  return pool_->frames;
}

SensorMeasurement SensorPool::measure() const {
  SensorMeasurement result;
  for (Pool::OfSize& blocks : pool_->sizes) {
    result = blocks.estimation.describe(pool_->first);
    if (result.estimate.blocks == 0) continue;
    result.correlation = blocks.correlation.measured();
    const double length = result.estimate.blotch_length / pool_->first.steps.side();
    result.correlation_fit = blocks.correlation.expected(result.grain, result.blotches, length);
    break;
  }
  return result;
}

}  // namespace epcc
