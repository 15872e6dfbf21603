// SPDX-License-Identifier: BSD-3-Clause
// The model of a stream: medians over its last estimates.
#include <algorithm>
#include <vector>

#include "epcc_segmentation/sensor_estimation.h"
#include "geometry/sensor_cloud.h"
#include "inverse_depth/scattered_pixels.h"
#include "quantile.h"
#include "sensor/image_estimation.h"

namespace epcc {

namespace {

constexpr std::size_t kMostReserved = 1000;  // estimates

}  // namespace

/// What is remembered, and the round of frames that is under way.
struct SensorEstimator::Stream {
  Stream(std::size_t memory_size, std::size_t frames_a_round)
      : memory(std::max<std::size_t>(memory_size, 1)),
        interval(std::clamp<std::size_t>(frames_a_round, 1, kMaxBlocks)) {
    estimates.reserve(std::min(memory, kMostReserved));
    values.reserve(std::min(memory, kMostReserved));
  }

  const std::size_t memory;
  const std::size_t interval;
  Turn first;  // of the frames before the memory is full
  int width = 0;
  int height = 0;
  SensorCloud cloud;
  InverseDepthImage image;  // of frames that nobody has read
  ScatteredPixels scattered;
  ImageEstimation estimation;
  std::size_t looked_at = 0;
  std::size_t first_block = 0;  // of the last frame among the flat ones
  // the round
  std::size_t frame = 0;
  int block_size = 0;
  // the memory
  std::vector<SensorEstimate> estimates;
  std::size_t oldest = 0;
  SensorEstimate summary;
  std::vector<double> values;  // to find the medians of

  void reset();
  void update(const InverseDepthImage& next);
  void measureWhole(const InverseDepthImage& next);
  void measureTurn(const InverseDepthImage& next);
  void remember(const SensorEstimate& latest);
  void summarize();
};

void SensorEstimator::Stream::reset() {
  estimates.clear();
  oldest = 0;
  frame = 0;
  block_size = ImageEstimation::blockSize(width, height);
}

void SensorEstimator::Stream::update(const InverseDepthImage& next) {
  if (next.width != width || next.height != height) {
    width = next.width;
    height = next.height;
    reset();
  }
  if (estimates.size() < memory)
    measureWhole(next);
  else
    measureTurn(next);
}

void SensorEstimator::Stream::measureWhole(const InverseDepthImage& next) {
  const SensorEstimate latest = estimation.share(next, first);
  looked_at = estimation.lookedAt();
  first_block = 0;
  remember(latest);
}

// Blocks of one size come first, as in a whole image; a round that finds nothing with them is followed by one with
// those of the other size.
void SensorEstimator::Stream::measureTurn(const InverseDepthImage& next) {
  if (frame == 0) estimation.begin(block_size);
  const std::size_t before = estimation.lookedAt();
  first_block = estimation.flatBlocks().size();
  estimation.measure(next, {static_cast<int>(frame), static_cast<int>(interval)});
  looked_at = estimation.lookedAt() - before;
  if (++frame < interval) return;
  frame = 0;
  const SensorEstimate latest = estimation.estimate(next);
  const int first_size = ImageEstimation::blockSize(width, height);
  const bool nothing_found = latest.blocks == 0 && block_size == first_size;
  block_size = nothing_found ? ImageEstimation::otherSize(first_size) : first_size;
  remember(latest);
}

void SensorEstimator::Stream::remember(const SensorEstimate& latest) {
  if (latest.blocks > 0) {
    if (estimates.size() < memory)
      estimates.push_back(latest);
    else
      estimates[oldest++ % memory] = latest;
  }
  if (estimates.empty())
    summary = latest;
  else
    summarize();
}

void SensorEstimator::Stream::summarize() {
  const auto median = [this](double SensorEstimate::*value) {
    values.clear();
    for (const SensorEstimate& estimate : estimates) values.push_back(estimate.*value);
    return quantile(values, 0.5);
  };
  summary.blocks = 0;
  for (const SensorEstimate& estimate : estimates) summary.blocks += estimate.blocks;
  summary.correlation_length = median(&SensorEstimate::correlation_length);
  summary.blotch_length = median(&SensorEstimate::blotch_length);
  summary.blotch_share = median(&SensorEstimate::blotch_share);
  summary.effective_length = median(&SensorEstimate::effective_length);
  summary.correlated_share = median(&SensorEstimate::correlated_share);
  summary.a = median(&SensorEstimate::a);
  summary.b = median(&SensorEstimate::b);
}

SensorEstimator::SensorEstimator(std::size_t memory, std::size_t interval)
    : stream_(std::make_unique<Stream>(memory, interval)) {}
SensorEstimator::SensorEstimator(const SensorEstimator& other) : stream_(std::make_unique<Stream>(*other.stream_)) {}
SensorEstimator& SensorEstimator::operator=(const SensorEstimator& other) {
  if (this != &other) stream_ = std::make_unique<Stream>(*other.stream_);
  return *this;
}
SensorEstimator::~SensorEstimator() = default;

SensorEstimate SensorEstimator::update(const DepthFrame& frame) {
  if (frame.empty()) return stream_->summary;  // nothing to learn
  stream_->image.read(inSensorFrame(frame, stream_->cloud));
  return update(stream_->scattered.measuredForm(stream_->image));
}

SensorEstimate SensorEstimator::update(const InverseDepthImage& image) {
  stream_->update(image);
  return stream_->summary;
}

SensorEstimate SensorEstimator::latest() const {
  return stream_->summary;
}

bool SensorEstimator::isSettled() const {
  return stream_->estimates.size() == stream_->memory;
}

std::pair<const BlockResiduals*, std::size_t> SensorEstimator::lastBlocks() const {
  const auto& blocks = stream_->estimation.flatBlocks();
  return {blocks.data() + stream_->first_block, blocks.size() - stream_->first_block};
}

std::size_t SensorEstimator::blocksLookedAt() const {
  return stream_->looked_at;
}

void SensorEstimator::reset(int first_interval) {
  const int phases = std::clamp(first_interval, 1, 10);
  stream_->first = {phases - 1, phases};
  stream_->reset();
}

}  // namespace epcc
