// SPDX-License-Identifier: BSD-3-Clause
// Pixels at borders choose between their own plane and that of the block that they face, in vectors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/inverse_depth_parameters.h"
#include "inverse_depth/block_membership.h"

namespace epcc {

/// One question for each of some pixels, no two for the same: would it rather be the other block's?
class BorderQuestions {
 public:
  /// The labels of a block and of the one that some of its pixels face, and the sign of own plane - other plane on the
  /// own side of a crease between the two, 0 if there is none.
  struct Question {
    std::int32_t own = 0, other = 0;
    float side = 0.0f;
  };

  /// For so many questions.
  void makeRoomFor(std::size_t questions) {
    if (questions + kMostLanes > rows_.size()) grow(questions + kMostLanes);
  }
  std::size_t count() const { return count_; }
  void clear() { count_ = 0; }
  /// Asks the pixels of a rectangle.
  void add(const Question& question, int row_begin, int row_end, int column_begin, int column_end) {
    makeRoom(static_cast<std::size_t>(row_end - row_begin) * static_cast<std::size_t>(column_end - column_begin));
    for (int row = row_begin; row < row_end; ++row)
      for (int column = column_begin; column < column_end; ++column) {
        rows_[count_] = row;
        columns_[count_] = column;
        owns_[count_] = question.own;
        others_[count_] = question.other;
        sides_[count_++] = question.side;
      }
  }
  /// As the kernel sees them: the last one repeated up to a whole number of vectors.
  struct Arrays {
    std::size_t count, asked;  ///< with those that were repeated, and without
    const std::int32_t *rows, *columns, *owns, *others;
    const float* sides;
  };
  Arrays filledUp();

 private:
  void makeRoom(std::size_t more) {
    if (count_ + more + kMostLanes > rows_.size()) grow(2 * (count_ + more) + kMostLanes);
  }
  void grow(std::size_t size);

  static constexpr std::size_t kMostLanes = 16;
  std::size_t count_ = 0;
  std::vector<std::int32_t> rows_, columns_, owns_, others_;
  std::vector<float> sides_;
};

/// What the answers depend on. All images are row-major and of this width.
struct BorderPixels {
  const float* w;
  RaysOfPixels rays;
  const float* scale;  ///< per row: measured inverse depth = w * scale
  std::int32_t width;
  const PixelPlane* planes;  ///< per label
  const InverseDepthNoise* noise;
  float max_residual, flip_gain, crease_range, crease_slack;  ///< InverseDepthParameters::Refinement
};

/// Changes the labels of the pixels that would, and how many pixels each label has, and forgets the questions. With e
/// the residual in sigma across the surface, the other plane is taken if e_other < e_own - flip_gain, by a pixel
/// without a label if e_other < max_residual; at a crease, where planes and pixel are within crease_range of each
/// other, if the pixel lies on the other side of it and e_other < e_own + crease_slack.
void decideBorderPixels(const BorderPixels& image, BorderQuestions& questions, std::int32_t* labels, long* pixels);

}  // namespace epcc
