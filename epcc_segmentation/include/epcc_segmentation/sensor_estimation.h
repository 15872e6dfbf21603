// SPDX-License-Identifier: BSD-3-Clause
// The sensor model measured on the frames themselves: what `--noise auto` uses.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/export.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// How far the error of a sensor is correlated.
enum class NoiseClass {
  White,  ///< structured light, laser: each pixel on its own
  Mid,    ///< Kinect type: blotches of a few pixels
  Long    ///< RealSense type: blotches of many pixels
};

/// What one frame tells of its sensor.
struct SensorEstimate {
  NoiseClass noise_class = NoiseClass::Mid;
  double a = 0.0023;                ///< metres, see SensorModel::axial
  double b = 0.0036;                ///< 1/m
  double correlation_length = 4.0;  ///< pixels
  std::size_t blocks = 0;           ///< flat image blocks that were measured; 0: nothing was, the values are generic

  SensorModel model() const { return SensorModel::axial(a, b, correlation_length); }
};

/// Fits planes to small blocks of the frame and reads the error off their residuals: its size by depth, corrected for
/// what the fits absorb of it, and the radius of its blotches. Clutter only enlarges residuals, so low quantiles are
/// used. A few milliseconds at 640x480.
EPCC_CORE_EXPORT SensorEstimate estimateSensor(const DepthFrame& frame);

struct InverseDepthImage;  // internal: a frame that has been read

/// The same over a stream of one sensor: the median of a and b, the majority class and its median length over the last
/// frames, so that the model settles and does not flicker.
class EPCC_CORE_EXPORT SensorEstimator {
 public:
  /// memory: number of frames whose estimates are remembered, at least 1. interval: once the memory is full, only every
  /// interval-th frame is measured, which saves time, at least 1. After a change of the sensor the model follows when
  /// more than half of the remembered frames are from the new one.
  explicit SensorEstimator(std::size_t memory = 15, std::size_t interval = 4);
  /// Measures a frame, if its turn has come, and returns the estimate of the stream. A change of the image size starts
  /// afresh.
  SensorEstimate update(const DepthFrame& frame);
  /// The same of a frame that has been read; if it is not due, of any image of its size.
  SensorEstimate update(const InverseDepthImage& image);
  /// Whether the next frame, of this size in pixels, will be measured.
  bool isDue(int width, int height) const;
  void reset();

 private:
  SensorEstimate take(const SensorEstimate& latest);
  SensorEstimate summary(SensorEstimate stream) const;

  std::size_t memory_;
  std::size_t interval_;
  std::size_t skipped_ = 0;  // frames since the last that was measured
  int width_ = 0;
  int height_ = 0;
  std::size_t next_ = 0;
  std::vector<SensorEstimate> estimates_;
  SensorEstimate stream_;
};

}  // namespace epcc
