// SPDX-License-Identifier: BSD-3-Clause
// What speaks against a result although nothing failed.
#pragma once

#include <cstdint>
#include <string>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/depth_view.h"
#include "epcc_segmentation/export.h"

namespace epcc {

struct SensorEstimate;
struct InverseDepthImage;  // internal: a frame that has been read

/// What is known of a frame that makes its planes doubtful: depth that looks like noise, a sensor that could not be
/// measured, few pixels.
struct EPCC_CORE_EXPORT Doubts {
  /// The sensor was to be measured and could not be: the values of SensorEstimate() were taken, of no sensor.
  bool sensor_is_generic = false;
  /// Standard deviation of the measured error at the frame's median depth, divided by that depth; 0 if none was
  /// measured. Sensors have a few percent; from 0.1 on the depth is doubtful: no depth image, 16-bit values with their
  /// bytes swapped, another unit than was said.
  double error_share = 0.0;
  /// Of neighbouring pixels whose depths differ, the share that differs by over a tenth: up to 0.05 in scenes, at the
  /// edges of things; from 0.1 on the depth may be no surface, as with 16-bit values whose bytes are swapped. 0 where
  /// pixels are scattered.
  double jump_share = 0.0;
  /// Pixels that are measured, as a share of the frame's, if they are scattered over it; 0 where of() finds none; else
  /// 1. Below 0.05 only large planes can be found.
  double scattered_share = 1.0;
  /// Of the pixels that are measured, the share that has exactly the largest or exactly the smallest depth of the
  /// frame, if it is 0.01 at least and they stand apart, nine of ten of their neighbours in a row being a tenth nearer
  /// or farther: they may be what a sensor or a renderer gives where it measures nothing. Else 0, as for scans and
  /// where pixels are scattered.
  double limit_share = 0.0;
  /// That depth, metres; 0 if `limit_share` is.
  double limit_depth = 0.0;
  /// Of a depth image of 16-bit values, see bytesAreSwapped().
  bool bytes_are_swapped = false;

  /// Whether any of these is so large, or so small, that inWords() has something to say.
  bool any() const;
  /// One line without its end; empty if there is nothing to say.
  std::string inWords() const;

  /// Of a frame and what was measured on it, as estimateSensor() gives it.
  static Doubts of(const DepthFrame& frame, const SensorEstimate& measured);
};

/// True if neighbouring values jump as they are and are smooth once the two bytes of each are swapped: as when a reader
/// took a PNG's numbers, big-endian, for the machine's own. Looks at the pairs of valid neighbours in some rows; false
/// where there are too few of them.
EPCC_CORE_EXPORT bool bytesAreSwapped(const DepthView<std::uint16_t>& depth);

}  // namespace epcc
