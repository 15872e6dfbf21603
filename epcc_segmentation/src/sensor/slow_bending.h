// SPDX-License-Identifier: BSD-3-Clause
// The part of a sensor's error that bends surfaces over more than a block: blocks' planes beside those of their
// regions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "correlated_error.h"
#include "inverse_depth/inverse_depth_image.h"
#include "plane_fit_samples.h"
#include "sensor/block_residuals.h"

namespace epcc {

/// A frame's regions with their fits along rays.
struct FittedRegions {
  const std::vector<std::int32_t>& labels;
  const std::vector<Plane>& planes;
  const SensorModel& sensor;
  const PlaneFitter& fitter;
};

/// The sensor's estimate sees what quadrics leave of blocks. What they take is seen here: how far the plane of a block
/// lies in front of or behind that of the region which the block is part of, and how it is turned against it. The last
/// few hundred blocks count; keeps its memory.
class SlowBending {
 public:
  SlowBending();
  void reset();
  /// Not of spherical scans, scattered pixels and transposed views, nor without a fit along the rays.
  static bool canMeasure(const DepthFrame& frame, const InverseDepthImage& image, const FitSamples& samples);
  /// Adds the flat blocks that were measured on a frame; what the blocks say of the error with the bending that
  /// explains all of them: their offsets say how much of it there is, their slopes how long it is.
  ErrorCorrelation update(const std::pair<const BlockResiduals*, std::size_t>& blocks, const InverseDepthImage& image,
                          const ErrorCorrelation& measured, const FittedRegions& regions);

 private:
  /// Squares in units of the error's variance.
  struct Seen {
    double offset, right, down;
  };
  void addBlocks(const std::pair<const BlockResiduals*, std::size_t>& blocks, const InverseDepthImage& image,
                 const ErrorCorrelation& error, const FittedRegions& regions);
  void addBlock(const BlockResiduals& block, const InverseDepthImage& image, const ErrorCorrelation& error,
                const FittedRegions& regions);
  ErrorCorrelation explain(const ErrorCorrelation& measured);

  int width_ = 0, height_ = 0;  // of the image; another one is another sensor
  int side_ = 0;
  std::size_t next_ = 0;
  std::vector<Seen> seen_;  // a ring
  std::vector<double> offsets_, slopes_;
};

}  // namespace epcc
