// SPDX-License-Identifier: BSD-3-Clause
// Labels of all pixels from those of the grid of samples.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "inverse_depth/block_membership.h"
#include "inverse_depth/border_pixels.h"
#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/label_borders.h"
#include "inverse_depth/region_map.h"
#include "plane_fit_samples.h"

namespace epcc {

/// A thread's memory of the border that it looks at.
struct BorderMemory {
  RowBits borders;
  PixelList places;
  std::vector<int> run_begins;  ///< of the blocks of a row of samples
  std::vector<std::int32_t> run_labels;
  BorderQuestions questions;
  std::vector<long> pixels;   ///< that have got each label from this thread, less those that have lost it
  std::vector<RowSpan> rows;  ///< of samples with each label, that this thread has seen
};

/// A sample stands for the block of pixels around it, more at the right and lower edge. Its pixels
/// that lie on the sample's plane take its label; then those of blocks that border on another label compare their own
/// with the blocks that they face, by the rule of S5. Nothing depends on the order of the pixels. Keeps its memory.
class FullResolution {
 public:
  /// `map` has the labels of a grid of these steps; `labels` receives those of the image, row-major. sigma_w is that of
  /// `noise`.
  void label(const InverseDepthImage& image, const InverseDepthNoise& noise, const RegionMap& map,
             const GridSteps& steps, const InverseDepthParameters::Refinement& rule, int threads,
             std::vector<std::int32_t>& labels);

  /// How many pixels have each label; meaningless for 0.
  const std::vector<long>& pixelCounts() const { return border_memory_.front().pixels; }
  /// Rows that hold all pixels of each label; meaningless for 0.
  const std::vector<RowSpan>& pixelRows() const { return pixel_rows_; }

 private:
  void listRows(const GridSteps& steps, int height);
  void takePlanes(const std::vector<PlaneMoments>& regions);

  std::vector<float> across_, along_, forward_, scale_;
  std::vector<PixelPlane> planes_;           // per label
  std::vector<BorderMemory> border_memory_;  // per thread
  std::vector<RowSpan> pixel_rows_;          // per label
  std::vector<std::uint8_t> begins_part_;    // per row of samples: another thread may have had the row above
};

}  // namespace epcc
