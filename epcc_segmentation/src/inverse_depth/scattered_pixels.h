// SPDX-License-Identifier: BSD-3-Clause
// Frames that measure only some of their pixels, scattered or in a pattern -> an image of blocks that hold one each.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "inverse_depth/grid_steps.h"
#include "inverse_depth/inverse_depth_image.h"

namespace epcc {

/// Every other ring of a scanner, a depth image with every second column, a scanner's points in a camera's image: many
/// valid pixels have no valid neighbour, and neither scan lines nor regions nor image blocks hold together. Such a
/// frame is taken as one of fewer, larger pixels: blocks as small as leave few holes between them, each with the valid
/// pixel next to its middle. So is a large image, of which only some pixels are samples, where every sixth pixel is
/// missing: blocks of the size of its grid have a sample where the grid itself has none. A row of blocks has the mean
/// ray of its pixels, exact where they lie in a row; where they do not, what they lie beside it adds to the place
/// variance. Keeps its memory.
class ScatteredPixels {
 public:
  /// Looks at an image that has been read. True if its pixels are scattered: then blocks() are what is seen of it,
  /// until the next call.
  bool find(const InverseDepthImage& image);

  InverseDepthImage& blocks() { return blocks_; }
  /// After find() was true: whether the image could be taken as it is, too, with holes.
  bool holdsTogether() const { return holds_together_; }
  /// After find() was true: what the sensor's error is measured on, the image as it is down to half of the neighbours.
  const InverseDepthImage& measurable(const InverseDepthImage& image) const { return tells_error_ ? image : blocks_; }
  /// Of each block, row after row: the index of the pixel that is its sample, -1 none.
  const std::vector<std::int32_t>& samplePixels() const { return sample_pixel_; }
  /// Share of the pixels of the last image that are valid, from a sixth of its rows.
  double validShare() const { return valid_share_; }

  /// What the sensor's error is measured on, of any image.
  const InverseDepthImage& measuredForm(const InverseDepthImage& image) {
    return find(image) ? measurable(image) : image;
  }

 private:
  GridSteps chooseSteps(const InverseDepthImage& image);
  void fill(const InverseDepthImage& image, const GridSteps& steps);
  void takeRays(const InverseDepthImage& image);

  /// Sums over the samples of a row or a column of blocks.
  struct MeanRay {
    double count = 0.0, x = 0.0, z = 0.0, xx = 0.0;
    void add(double next_x, double next_z) {
      count += 1.0;
      x += next_x;
      z += next_z;
      xx += next_x * next_x + next_z * next_z;
    }
    double squaresAbout(double mean_x, double mean_z) const {
      const double moved = 2.0 * (mean_x * x + mean_z * z) - count * (mean_x * mean_x + mean_z * mean_z);
      return std::max(0.0, xx - moved);
    }
  };

  InverseDepthImage blocks_;
  std::vector<std::uint8_t> is_filled_;
  std::vector<float> column_filled_;  // valid pixels of each column of a row of blocks
  std::vector<int> block_of_column_;
  std::vector<MeanRay> row_rays_, column_rays_;
  std::vector<std::int32_t> sample_pixel_;
  double valid_share_ = 0.0;
  bool holds_together_ = false;
  bool tells_error_ = false;
};

}  // namespace epcc
