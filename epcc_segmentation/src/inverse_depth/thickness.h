// SPDX-License-Identifier: BSD-3-Clause
// S9: how likely a region is a surface; those that are thin for their size are clutter.
#pragma once

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/label_borders.h"
#include "inverse_depth/region_map.h"

namespace epcc {

/// Kept from frame to frame.
struct ThicknessMemory {
  /// A thread's.
  struct Sweep {
    RowBits left, above;
    PixelList pixels;
    std::vector<double> border;  ///< per label
  };
  std::vector<Sweep> sweeps;
  std::vector<std::int32_t> new_label;
  struct Kept {
    PlaneMoments region;
    std::size_t index;
    double confidence;
  };
  std::vector<Kept> kept;
};

/// Rates how likely each region is a surface, and unlabels those below min_confidence. Surfaces are thick for their
/// size, clutter is ragged: t = n / P with P the border, an edge to a pixel with depth counting 1, to a hole a quarter,
/// the image's edge nothing. The score is
///   s = t / (4 chi^1.2 (n / (30 L))^-0.6),
/// in pixels of an image 640 wide, L the pixels that an independent sample covers, at most 100; the confidence
///   0.4 s^1.5 / (0.4 s^1.5 + 1).
/// `steps` are those of the grid of `image`, `sensor` in pixels of it. What is left is numbered anew, the largest
/// first: the planes of the result are, too, and few pixels have to change their number once more.
void rejectThin(const InverseDepthImage& image, const InverseDepthParameters& parameters, const SensorModel& sensor,
                const GridSteps& steps, RegionMap& map, ThicknessMemory& memory, int threads = 1);

}  // namespace epcc
