// SPDX-License-Identifier: BSD-3-Clause
// The sensor model measured on the frames themselves: what `--noise auto` uses.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/export.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// What one frame tells of its sensor.
struct SensorEstimate {
  double a = 0.0023;                ///< metres, see SensorModel::axial
  double b = 0.0036;                ///< 1/m
  double correlation_length = 4.0;  ///< pixels
  double blotch_length = 0.0;       ///< radius of the blotches that were seen, pixels
  double blotch_share = 0.0;        ///< of the error's variance; the rest is grain, which differs from pixel to pixel
  double effective_length = 0.0;    ///< of blotches alone with as many pixels a sample; 0.4 is grain alone
  double correlated_share = 1.0;    ///< of the model's variance, in which whole surfaces err together
  std::size_t blocks = 0;           ///< flat image blocks that were measured; 0: nothing was, the values are generic

  /// For PlaneExtractor::setSensor() and the like.
  SensorModel model() const {
    return SensorModel::axial(a, b, correlation_length).withCorrelatedShare(correlated_share);
  }
};

/// Fits quadrics to small blocks of the frame and to their parts, and reads the error off their residuals: its size by
/// depth, corrected for what the fits absorb of it, and how far it is correlated. Curved surfaces and the slow bending
/// of a sensor drop out, clutter only enlarges residuals, so low quantiles are used. In any unit of length. A fraction
/// of a millisecond at 640x480, beside the reading of the frame.
EPCC_CORE_EXPORT SensorEstimate estimateSensor(const DepthFrame& frame);

/// What an estimate comes from, for reports. Where pixels are scattered it is measured on blocks that hold one each:
/// sides and lags are then in blocks.
struct SensorMeasurement {
  /// A block of the image and what a quadric leaves in it.
  struct Block {
    double depth;     ///< metres
    double residual;  ///< rms, across the surface, metres
  };
  /// A range of depths.
  struct Bin {
    double depth;        ///< metres
    double error;        ///< standard deviation of the sensor's error, metres
    double sigma;        ///< what the model is to say, metres
    std::size_t blocks;  ///< in it
  };
  SensorEstimate estimate;           ///< the model that follows from it
  std::vector<Block> blocks;         ///< all flat blocks
  std::vector<Bin> bins;             ///< from near to far
  double grain = 0.0;                ///< variance of the grain, in units of a block's mean square after a quadric
  double blotches = 0.0;             ///< variance of the blotches, in the same units
  std::array<int, 3> sides{};        ///< of the parts of blocks that quadrics are fitted to, too; pixels
  std::array<double, 3> kept{};      ///< mean squares that these leave, in the same units ...
  std::array<double, 3> kept_fit{};  ///< ... and what grain and blotches say that they leave
  /// Autocorrelation of the residuals of the blocks' quadrics at lags of 0, 1, ... pixels. Quadrics leave no long
  /// waves, so that it falls below zero.
  std::vector<double> correlation;
  std::vector<double> correlation_fit;  ///< what grain and blotches say that it is
};

/// Frames of one camera pooled: all their blocks count as those of one frame.
class EPCC_CORE_EXPORT SensorPool {
 public:
  /// A pool without frames.
  SensorPool();
  ~SensorPool();
  /// Takes over the frames; the other is not for use afterwards.
  SensorPool(SensorPool&&) noexcept;
  /// Takes over the frames; the other is not for use afterwards.
  SensorPool& operator=(SensorPool&&) noexcept;
  /// False for a frame that is empty, of another size than the first, or whose pixels are scattered unlike those of the
  /// first: it is left out.
  bool add(const DepthFrame& frame);
  /// Frames that were added, without those left out.
  std::size_t frames() const;
  /// Of all frames so far. estimate.blocks is 0 if nothing could be measured.
  SensorMeasurement measure() const;

 private:
  struct Pool;
  std::unique_ptr<Pool> pool_;
};

struct InverseDepthImage;  // internal: a frame that has been read
struct BlockResiduals;     // internal: a block of it

/// The same over a stream of one sensor: the median of each value over the last estimates, so that the model settles
/// and does not flicker. Keeps its memory from frame to frame.
///
/// Until `memory` estimates are remembered, each frame gives one. From then on the cost is spread evenly: a frame
/// measures every interval-th block, the next frame those beside them, and after `interval` frames, a round, all blocks
/// of the round give an estimate, which replaces the oldest. So the model changes once a round at most. After a change
/// of the sensor it follows when more than half of the remembered estimates are of the new one: at the latest after
/// interval * (memory / 2 + 2) - 1 frames, 35 as a rule.
class EPCC_CORE_EXPORT SensorEstimator {
 public:
  /// `memory` is the number of estimates that are remembered, at least 1: raise it for a steadier model, lower it to
  /// follow a change sooner. `interval` is the number of frames in a round, 1 to 150, for a frame measures one block at
  /// least: raise it to spend less time on a frame.
  explicit SensorEstimator(std::size_t memory = 15, std::size_t interval = 4);
  /// Goes on from the estimates that the other remembers.
  SensorEstimator(const SensorEstimator& other);
  /// Goes on from the estimates that the other remembers.
  SensorEstimator& operator=(const SensorEstimator& other);
  ~SensorEstimator();

  /// Measures a frame, or its share of the blocks, and returns the estimate of the stream. A change of the image size
  /// starts afresh.
  SensorEstimate update(const DepthFrame& frame);
  /// The same of a frame that has been read: for the library itself.
  SensorEstimate update(const InverseDepthImage& image);
  /// What the last update returned.
  SensorEstimate latest() const;
  /// Whether as many estimates are remembered as can be.
  bool isSettled() const;
  /// Image blocks, large and small, that the last update looked at, flat or not: what it cost.
  std::size_t blocksLookedAt() const;
  /// Internal: the flat blocks among those that the last update looked at, until the next.
  std::pair<const BlockResiduals*, std::size_t> lastBlocks() const;
  /// Starts afresh. Until the memory is full a frame measures every first_interval-th block, 1 to 10.
  void reset(int first_interval = 1);

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

}  // namespace epcc
