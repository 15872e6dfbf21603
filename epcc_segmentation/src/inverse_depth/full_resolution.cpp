// SPDX-License-Identifier: BSD-3-Clause
// Membership row by row, then the blocks along the borders.
#include "inverse_depth/full_resolution.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "inverse_depth/block_membership.h"
#include "parallel_for.h"

namespace epcc {

void LabelledPlanes::assign(const std::vector<PlaneMoments>& regions) {
  const std::size_t count = regions.size() + 1;
  for (std::vector<float>* part : {&q_across, &q_along, &q_forward, &slope}) part->assign(count, 0.0f);
  for (std::size_t label = 1; label < count; ++label) {
    const PlaneMoments& region = regions[label - 1];
    if (region.n <= 0.0) continue;
    const RegionPlane plane(region);
    q_across[label] = static_cast<float>(plane.q.x());
    q_along[label] = static_cast<float>(plane.q.y());
    q_forward[label] = static_cast<float>(plane.q.z());
    slope[label] = static_cast<float>(plane.slope_factor);
  }
}

namespace {

void toSingle(const std::vector<double>& values, std::vector<float>& single) {
  single.resize(values.size());
  std::transform(values.begin(), values.end(), single.begin(), [](double value) { return static_cast<float>(value); });
}

/// The blocks of one row of samples that border on another label.
class BorderBlocks {
 public:
  BorderBlocks(const InverseDepthImage& image, const InverseDepthNoise& noise, const RegionMap& map, int stride,
               const InverseDepthParameters::Refinement& rule, const LabelledPlanes& planes, std::int32_t* labels)
      : image_(image),
        noise_(noise),
        samples_(map.labels.data()),
        sample_rows_(sampleCount(image.height, stride)),
        sample_columns_(sampleCount(image.width, stride)),
        stride_(stride),
        probe_(std::max(1, (rule.crease_vote_pixels + stride / 2) / stride)),
        rule_(rule),
        planes_(planes),
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
  /// The block that a pixel faces, and, where it meets its own block's plane in a crease, on which side its own lies.
  struct Facing {
    std::int32_t label = 0;
    float own_side = 0.0f;  // sign of own plane - other plane on the own side of the crease; 0: no crease
  };

  std::int32_t sampleAt(int row, int column) const {
    if (row < 0 || row >= sample_rows_ || column < 0 || column >= sample_columns_) return 0;
    return samples_[static_cast<std::ptrdiff_t>(row) * sample_columns_ + column];
  }

  float planeAt(std::int32_t label, int row, int column) const {
    const auto k = static_cast<std::size_t>(label);
    return planes_.q_across[k] * static_cast<float>(image_.across[static_cast<std::size_t>(column)]) +
           planes_.q_along[k] * static_cast<float>(image_.along[static_cast<std::size_t>(row)]) +
           planes_.q_forward[k] * static_cast<float>(image_.forward[static_cast<std::size_t>(column)]);
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
    facing.label = sampleAt(row + down, column + right);
    if (facing.label == own || facing.label == 0 || own == 0) return facing;
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
    for (int row = row_begin; row < row_end; ++row)
      for (int column = column_begin; column < column_end; ++column)
        decidePixel(row, column, {next[half(column - column_begin)], beside[half(row - row_begin)]});
  }

  void decidePixel(int row, int column, const std::array<Facing, 2>& facing) {
    const std::size_t pixel = image_.index(row, column);
    const float w = image_.w[pixel];
    const std::int32_t current = labels_[pixel];
    if (!(w > 0.0f)) return;
    const double scale = image_.measured_scale[static_cast<std::size_t>(row)];
    const auto inverse_sigma = static_cast<float>(scale / std::sqrt(noise_.variance(static_cast<double>(w) * scale)));
    const auto error = [&](std::int32_t of) {
      return std::abs(w - planeAt(of, row, column)) * inverse_sigma /
             std::sqrt(planes_.slope[static_cast<std::size_t>(of)]);
    };
    const auto range = static_cast<float>(rule_.crease_range);
    const float current_error = current != 0 ? error(current) : static_cast<float>(rule_.max_residual);
    float least = current != 0 ? current_error - static_cast<float>(rule_.flip_gain) : current_error;
    std::int32_t best = current;
    for (const Facing& other : facing) {
      if (other.label == 0 || other.label == current || other.label == best) continue;
      const float e = error(other.label);
      if (current != 0 && other.own_side != 0.0f && current_error < range && e < range) {
        const float difference = planeAt(current, row, column) - planeAt(other.label, row, column);
        if (std::abs(difference) * inverse_sigma < range) {
          if (difference * other.own_side < 0.0f && e < current_error + static_cast<float>(rule_.crease_slack))
            best = other.label, least = std::min(least, e);
          continue;
        }
      }
      if (e >= least) continue;
      least = e;
      best = other.label;
    }
    labels_[pixel] = best;
  }

  const InverseDepthImage& image_;
  const InverseDepthNoise& noise_;
  const std::int32_t* samples_;
  int sample_rows_, sample_columns_;
  int stride_;
  int probe_;  // samples between the border and what lies to its sides
  const InverseDepthParameters::Refinement& rule_;
  const LabelledPlanes& planes_;
  std::int32_t* labels_;
};

}  // namespace

void FullResolution::label(const InverseDepthImage& image, const InverseDepthNoise& noise, const RegionMap& map,
                           int stride, const InverseDepthParameters::Refinement& rule, int threads,
                           std::vector<std::int32_t>& labels) {
  labels.resize(image.w.size());
  toSingle(image.across, across_);
  toSingle(image.forward, forward_);
  planes_.assign(map.regions);
  const int sample_columns = sampleCount(image.width, stride);
  const int sample_rows = sampleCount(image.height, stride);
  parallelFor(sample_rows, threads, [&](int /*thread*/, int begin, int end) {
    BorderBlocks borders(image, noise, map, stride, rule, planes_, labels.data());
    for (int sample_row = begin; sample_row < end; ++sample_row) {
      const int row_end = sample_row + 1 < sample_rows ? (sample_row + 1) * stride : image.height;
      for (int row = sample_row * stride; row < row_end; ++row) {
        const auto r = static_cast<std::size_t>(row);
        labelMembers({image.w.data() + image.index(row, 0), across_.data(), forward_.data(),
                      static_cast<float>(image.along[r]), static_cast<float>(image.measured_scale[r]), image.width,
                      map.labels.data() + static_cast<std::ptrdiff_t>(sample_row) * sample_columns, sample_columns,
                      stride, planes_.q_across.data(), planes_.q_along.data(), planes_.q_forward.data(),
                      planes_.slope.data(), &noise, static_cast<float>(rule.max_residual * rule.max_residual)},
                     labels.data() + image.index(row, 0));
      }
      borders.decide(sample_row);
    }
  });
}

}  // namespace epcc
