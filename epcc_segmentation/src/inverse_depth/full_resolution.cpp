// SPDX-License-Identifier: BSD-3-Clause
// Membership row by row, then the blocks along the borders.
#include "inverse_depth/full_resolution.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "inverse_depth/block_membership.h"
#include "parallel_for.h"

namespace epcc {

namespace {

void toSingle(const std::vector<double>& values, std::vector<float>& single) {
  single.resize(values.size());
  std::transform(values.begin(), values.end(), single.begin(), [](double value) { return static_cast<float>(value); });
}

/// The blocks of one row of samples that border on another label.
class BorderBlocks {
 public:
  BorderBlocks(const InverseDepthImage& image, const InverseDepthNoise& noise, const RegionMap& map, int stride,
               const InverseDepthParameters::Refinement& rule, const PixelPlane* planes, const PixelRays& rays,
               std::int32_t* labels)
      : image_(image),
        noise_(noise),
        samples_(map.labels.data()),
        sample_rows_(sampleCount(image.height, stride)),
        sample_columns_(sampleCount(image.width, stride)),
        stride_(stride),
        probe_(std::max(1, (rule.crease_vote_pixels + stride / 2) / stride)),
        max_residual_(static_cast<float>(rule.max_residual)),
        flip_gain_(static_cast<float>(rule.flip_gain)),
        crease_range_(static_cast<float>(rule.crease_range)),
        crease_slack_(static_cast<float>(rule.crease_slack)),
        planes_(planes),
        rays_(rays),
        labels_(labels) {}

  void decide(int sample_row) {
    const std::int32_t* here = samples_ + static_cast<std::ptrdiff_t>(sample_row) * sample_columns_;
    const std::int32_t* above = sample_row > 0 ? here - sample_columns_ : here;
    const std::int32_t* below = sample_row + 1 < sample_rows_ ? here + sample_columns_ : here;
    for (int i = 0; i < sample_columns_; ++i) {
      const std::int32_t own = here[i];
      const std::int32_t left = i > 0 ? here[i - 1] : own;
      const std::int32_t right = i + 1 < sample_columns_ ? here[i + 1] : own;
      if (left == own && right == own && above[i] == own && below[i] == own) continue;
      decideBlock(sample_row, i);
    }
  }

 private:
  /// The label of the block that a pixel faces, 0 if it is none or its own block's; and, where the two planes meet in a
  /// crease, on which side its own lies.
  struct Facing {
    std::int32_t label = 0;
    float own_side = 0.0f;  // sign of own plane - other plane on the own side of the crease; 0: no crease
  };

  std::int32_t sampleAt(int row, int column) const {
    if (row < 0 || row >= sample_rows_ || column < 0 || column >= sample_columns_) return 0;
    return samples_[static_cast<std::ptrdiff_t>(row) * sample_columns_ + column];
  }

  float planeAt(std::int32_t label, int row, int column) const {
    const PixelPlane& plane = planes_[label];
    return plane.across * rays_.across[column] + plane.along * rays_.along[row] + plane.forward * rays_.forward[column];
  }

  float differenceAt(std::int32_t a, std::int32_t b, int sample_row, int sample_column) const {
    const int row = std::min(sample_row * stride_ + stride_ / 2, image_.height - 1);
    const int column = std::min(sample_column * stride_ + stride_ / 2, image_.width - 1);
    return planeAt(a, row, column) - planeAt(b, row, column);
  }

  // Both planes are linear in the image, and so is their difference: it changes its sign along the crease. What lies a
  // few samples to both sides of the border says whether there is one.
  Facing face(int row, int column, int down, int right) const {
    const std::int32_t own = sampleAt(row, column);
    Facing facing;
    const std::int32_t other = sampleAt(row + down, column + right);
    if (other == own || other == 0) return facing;
    facing.label = other;
    if (own == 0) return facing;
    const int back_row = row - probe_ * down, back_column = column - probe_ * right;
    const int forth_row = row + (probe_ + 1) * down, forth_column = column + (probe_ + 1) * right;
    if (sampleAt(back_row, back_column) != own || sampleAt(forth_row, forth_column) != facing.label) return facing;
    const float here = differenceAt(own, facing.label, back_row, back_column);
    const float there = differenceAt(own, facing.label, forth_row, forth_column);
    if (here * there < 0.0f) facing.own_side = here;
    return facing;
  }

  // A pixel faces the blocks that its half of the block is next to; one in the middle faces none.
  void decideBlock(int sample_row, int sample_column) {
    const std::array<Facing, 3> beside = {face(sample_row, sample_column, -1, 0), Facing(),
                                          face(sample_row, sample_column, 1, 0)};
    const std::array<Facing, 3> next = {face(sample_row, sample_column, 0, -1), Facing(),
                                        face(sample_row, sample_column, 0, 1)};
    const auto half = [this](int offset) { return offset < stride_ / 2 ? 0 : offset >= (stride_ + 1) / 2 ? 2 : 1; };
    const int row_begin = sample_row * stride_, column_begin = sample_column * stride_;
    const int row_end = sample_row + 1 < sample_rows_ ? row_begin + stride_ : image_.height;
    const int column_end = sample_column + 1 < sample_columns_ ? column_begin + stride_ : image_.width;
    for (int row = row_begin; row < row_end; ++row) {
      const Facing& second = beside[half(row - row_begin)];
      for (int column = column_begin; column < column_end; ++column) {
        const Facing& first = next[half(column - column_begin)];
        if (first.label != 0 || second.label != 0) decidePixel(row, column, first, second);
      }
    }
  }

  // By residuals, but where two planes meet in a crease by the side on which the pixel lies.
  void decidePixel(int row, int column, const Facing& first, const Facing& second) {
    const std::size_t pixel = image_.index(row, column);
    const float w = image_.w[pixel];
    if (!(w > 0.0f)) return;
    const double scale = image_.measured_scale[static_cast<std::size_t>(row)];
    const auto inverse_sigma = static_cast<float>(scale / std::sqrt(noise_.variance(static_cast<double>(w) * scale)));
    const auto errorOf = [&](std::int32_t label, float plane) {
      return std::abs(w - plane) * inverse_sigma * planes_[label].inverse_root_slope;
    };
    const std::int32_t current = labels_[pixel];
    const float current_plane = current != 0 ? planeAt(current, row, column) : 0.0f;
    const float current_error = current != 0 ? errorOf(current, current_plane) : max_residual_;
    float least = current != 0 ? current_error - flip_gain_ : current_error;
    std::int32_t best = current;
    for (const Facing* other : {&first, &second}) {
      if (other->label == 0 || other->label == best || other->label == current) continue;
      const float plane = planeAt(other->label, row, column);
      const float error = errorOf(other->label, plane);
      if (current != 0 && other->own_side != 0.0f && current_error < crease_range_ && error < crease_range_ &&
          std::abs(current_plane - plane) * inverse_sigma < crease_range_) {
        const bool own_side = (current_plane - plane) * other->own_side >= 0.0f;
        if (own_side || error >= current_error + crease_slack_) continue;
      } else if (error >= least) {
        continue;
      }
      least = std::min(least, error);
      best = other->label;
    }
    labels_[pixel] = best;
  }

  const InverseDepthImage& image_;
  const InverseDepthNoise& noise_;
  const std::int32_t* samples_;
  int sample_rows_, sample_columns_;
  int stride_;
  int probe_;  // samples between the border and what lies to its sides
  float max_residual_, flip_gain_, crease_range_, crease_slack_;
  const PixelPlane* planes_;
  const PixelRays& rays_;
  std::int32_t* labels_;
};

}  // namespace

void FullResolution::takePlanes(const std::vector<PlaneMoments>& regions) {
  planes_.assign(regions.size() + 1, PixelPlane());
  for (std::size_t k = 0; k < regions.size(); ++k) {
    if (regions[k].n <= 0.0) continue;
    const RegionPlane plane(regions[k]);
    planes_[k + 1] = {static_cast<float>(plane.q.x()), static_cast<float>(plane.q.y()), static_cast<float>(plane.q.z()),
                      static_cast<float>(plane.slope_factor), static_cast<float>(1.0 / std::sqrt(plane.slope_factor))};
  }
}

void FullResolution::label(const InverseDepthImage& image, const InverseDepthNoise& noise, const RegionMap& map,
                           int stride, const InverseDepthParameters::Refinement& rule, int threads,
                           std::vector<std::int32_t>& labels) {
  labels.resize(image.w.size());
  toSingle(image.across, across_);
  toSingle(image.along, along_);
  toSingle(image.forward, forward_);
  takePlanes(map.regions);
  const PixelRays rays{across_.data(), along_.data(), forward_.data()};
  const int sample_columns = sampleCount(image.width, stride);
  const int sample_rows = sampleCount(image.height, stride);
  parallelFor(sample_rows, threads, [&](int /*thread*/, int begin, int end) {
    BorderBlocks borders(image, noise, map, stride, rule, planes_.data(), rays, labels.data());
    for (int sample_row = begin; sample_row < end; ++sample_row) {
      const int row_end = sample_row + 1 < sample_rows ? (sample_row + 1) * stride : image.height;
      for (int row = sample_row * stride; row < row_end; ++row)
        labelMembers({image.w.data() + image.index(row, 0), across_.data(), forward_.data(), rays.along[row],
                      static_cast<float>(image.measured_scale[static_cast<std::size_t>(row)]), image.width,
                      map.labels.data() + static_cast<std::ptrdiff_t>(sample_row) * sample_columns, sample_columns,
                      stride, planes_.data(), &noise, static_cast<float>(rule.max_residual * rule.max_residual)},
                     labels.data() + image.index(row, 0));
      borders.decide(sample_row);
    }
  });
}

}  // namespace epcc
