// SPDX-License-Identifier: BSD-3-Clause
// Are the neighbours of valid pixels valid? If not, blocks grow until those of filled blocks are filled.
#include "inverse_depth/scattered_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "inverse_depth/sample_grid.h"

namespace epcc {

namespace {

constexpr double kManyPixels = 0.9;  // of all: such a frame is not asked further
// Share of valid pixels whose neighbour is valid; whole surfaces have over 0.9. Where a sample stands for several
// pixels anyway, a block that offers another one costs no resolution.
constexpr double kScattered = 0.7, kScatteredSamples = 0.85;
constexpr double kMeasurable = 0.5;    // the same of an image that tells the sensor's error as it is
constexpr double kHoldTogether = 0.8;  // the same of blocks
constexpr double kAlike = 0.1;         // shares that differ less grow together
constexpr int kLargestGridStep = 16;
constexpr int kFewestBlocks = 8;  // along a row or a column

/// Valid pixels, and how many of them have a valid neighbour to the right and below.
struct Neighbours {
  long valid = 0, right = 0, below = 0;
};

bool isValid(float w) {
  return w > 0.0f;
}

// Counters as wide as a float, and no branches: loops that compilers turn into vectors.

int countValid(const float* row, int width) {
  int count = 0;
  for (int i = 0; i < width; ++i) count += static_cast<int>(isValid(row[i]));
  return count;
}

int countPairs(const float* first, const float* second, int width) {
  int count = 0;
  for (int i = 0; i < width; ++i) count += static_cast<int>(isValid(first[i])) & static_cast<int>(isValid(second[i]));
  return count;
}

/// Calls visit(row) for a sixth of the rows, whose distances follow no pattern that a frame may have.
template <typename Visit>
void forSomeRows(int height, const Visit& visit) {
  for (int row = 0, step = 5; row < height; row += step, step = 13 - step) visit(row);
}

const float* rowOf(const InverseDepthImage& image, int row) {
  return image.w.data() + image.index(row, 0);
}

double shareOfValid(const InverseDepthImage& image) {
  long valid = 0, all = 0;
  forSomeRows(image.height, [&](int row) {
    valid += countValid(rowOf(image, row), image.width);
    all += image.width;
  });
  return all > 0 ? static_cast<double>(valid) / static_cast<double>(all) : 0.0;
}

/// Share of the valid pixels whose neighbour is valid, along rows or along columns, whichever is less.
double shareOfNeighbours(const InverseDepthImage& image) {
  Neighbours seen;
  forSomeRows(image.height - 1, [&](int row) {
    for (const int r : {row, row + 1}) {
      seen.valid += countValid(rowOf(image, r), image.width - 1);
      seen.right += countPairs(rowOf(image, r), rowOf(image, r) + 1, image.width - 1);
    }
    seen.below += 2 * countPairs(rowOf(image, row), rowOf(image, row + 1), image.width - 1);
  });
  return seen.valid > 0 ? static_cast<double>(std::min(seen.right, seen.below)) / static_cast<double>(seen.valid) : 1.0;
}

/// A pixel of a block, from its first one.
struct PlaceInBlock {
  int row, column;
};

/// All of them, those next to the middle first.
struct BlockOrder {
  std::array<PlaceInBlock, static_cast<std::size_t>(kLargestGridStep) * kLargestGridStep> places;
  int count = 0;

  explicit BlockOrder(const GridSteps& steps) {
    for (int row = 0; row < steps.along; ++row)
      for (int column = 0; column < steps.across; ++column) places[static_cast<std::size_t>(count++)] = {row, column};
    const auto beside = [&](const PlaceInBlock& p) {
      const int down = 2 * p.row + 1 - steps.along, right = 2 * p.column + 1 - steps.across;
      return down * down + right * right;
    };
    std::sort(places.begin(), places.begin() + count, [&](const PlaceInBlock& p, const PlaceInBlock& q) {
      if (beside(p) != beside(q)) return beside(p) < beside(q);
      return p.row != q.row ? p.row < q.row : p.column < q.column;
    });
  }
  const PlaceInBlock* begin() const { return places.data(); }
  const PlaceInBlock* end() const { return places.data() + count; }
};

}  // namespace

bool ScatteredPixels::find(const InverseDepthImage& image) {
  valid_share_ = shareOfValid(image);
  if (valid_share_ >= kManyPixels || image.width < 2 || image.height < 2) return false;
  const double neighbours = shareOfNeighbours(image);
  holds_together_ = neighbours >= kScattered;
  tells_error_ = neighbours >= kMeasurable;
  const bool is_sampled = strideFor(longerSide(image.width, image.height), 0) > 1;
  if (neighbours >= (is_sampled ? kScatteredSamples : kScattered)) return false;
  fill(image, chooseSteps(image));
  return true;
}

GridSteps ScatteredPixels::chooseSteps(const InverseDepthImage& image) {
  GridSteps steps(strideFor(longerSide(image.width, image.height), 0));
  block_of_column_.resize(static_cast<std::size_t>(image.width));
  for (;;) {
    const int width = sampleCount(image.width, steps.across), height = sampleCount(image.height, steps.along);
    for (int c = 0; c < image.width; ++c)
      block_of_column_[static_cast<std::size_t>(c)] = std::min(c / steps.across, width - 1);
    is_filled_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    for (int block = 0, r = 0; block < height; ++block) {
      column_filled_.assign(static_cast<std::size_t>(image.width), 0.0f);
      for (const int end = block + 1 < height ? r + steps.along : image.height; r < end; ++r) {
        const float* w = image.w.data() + image.index(r, 0);
        for (int c = 0; c < image.width; ++c)
          column_filled_[static_cast<std::size_t>(c)] += isValid(w[c]) ? 1.0f : 0.0f;
      }
      std::uint8_t* filled = is_filled_.data() + static_cast<std::ptrdiff_t>(block) * width;
      for (std::size_t c = 0; c < column_filled_.size(); ++c)
        filled[block_of_column_[c]] |= static_cast<std::uint8_t>(column_filled_[c] > 0.0f);
    }
    long with_right = 0, right = 0, with_below = 0, below = 0;
    for (int r = 0; r < height; ++r) {
      const std::uint8_t* row = is_filled_.data() + static_cast<std::ptrdiff_t>(r) * width;
      for (int c = 0; c + 1 < width; ++c) {
        with_right += row[c];
        right += row[c] & row[c + 1];
      }
      if (r + 1 == height) break;
      for (int c = 0; c < width; ++c) {
        with_below += row[c];
        below += row[c] & row[c + width];
      }
    }
    const double across = with_right > 0 ? static_cast<double>(right) / static_cast<double>(with_right) : 1.0;
    const double along = with_below > 0 ? static_cast<double>(below) / static_cast<double>(with_below) : 1.0;
    if (std::min(across, along) >= kHoldTogether) return steps;
    GridSteps next = steps;
    if (across < along + kAlike && image.width >= kFewestBlocks * (steps.across + 1)) ++next.across;
    if (along < across + kAlike && image.height >= kFewestBlocks * (steps.along + 1)) ++next.along;
    if (next == steps || std::max(next.across, next.along) > kLargestGridStep) return steps;
    steps = next;
  }
}

void ScatteredPixels::fill(const InverseDepthImage& image, const GridSteps& steps) {
  blocks_.width = sampleCount(image.width, steps.across);
  blocks_.height = sampleCount(image.height, steps.along);
  blocks_.steps = steps;
  blocks_.planar_rows = image.planar_rows;
  blocks_.closes_round = image.closes_round;
  blocks_.w.assign(static_cast<std::size_t>(blocks_.width) * static_cast<std::size_t>(blocks_.height), 0.0f);
  sample_pixel_.assign(blocks_.w.size(), -1);
  row_rays_.assign(static_cast<std::size_t>(blocks_.height), MeanRay());
  column_rays_.assign(static_cast<std::size_t>(blocks_.width), MeanRay());
  const BlockOrder order(steps);
  for (int r = 0; r < blocks_.height; ++r)
    for (int c = 0; c < blocks_.width; ++c)
      for (const PlaceInBlock& place : order) {
        const int row = r * steps.along + place.row, column = c * steps.across + place.column;
        if (row >= image.height || column >= image.width) continue;
        const float w = image.w[image.index(row, column)];
        if (!isValid(w)) continue;
        blocks_.w[blocks_.index(r, c)] = w;
        sample_pixel_[blocks_.index(r, c)] = static_cast<std::int32_t>(image.index(row, column));
        row_rays_[static_cast<std::size_t>(r)].add(image.along[static_cast<std::size_t>(row)], 0.0);
        column_rays_[static_cast<std::size_t>(c)].add(image.across[static_cast<std::size_t>(column)],
                                                      image.forward[static_cast<std::size_t>(column)]);
        break;
      }
  takeRays(image);
}

// Where a row or column of blocks has no sample its ray is that of its middle.
void ScatteredPixels::takeRays(const InverseDepthImage& image) {
  const auto middleOf = [](std::size_t block, int step, std::size_t count) {
    return std::min(block * static_cast<std::size_t>(step) + static_cast<std::size_t>(step / 2), count - 1);
  };
  double squares = 0.0, samples = 0.0;
  blocks_.along.resize(row_rays_.size());
  blocks_.measured_scale.resize(row_rays_.size());
  for (std::size_t r = 0; r < row_rays_.size(); ++r) {
    const MeanRay& ray = row_rays_[r];
    const double y =
        ray.count > 0.0 ? ray.x / ray.count : image.along[middleOf(r, blocks_.steps.along, image.along.size())];
    blocks_.along[r] = y;
    blocks_.measured_scale[r] = image.planar_rows ? 1.0 : 1.0 / std::sqrt(1.0 + y * y);
    squares += ray.squaresAbout(y, 0.0);
    samples += ray.count;
  }
  blocks_.across.resize(column_rays_.size());
  blocks_.forward.resize(column_rays_.size());
  for (std::size_t c = 0; c < column_rays_.size(); ++c) {
    MeanRay ray = column_rays_[c];
    const std::size_t middle = middleOf(c, blocks_.steps.across, image.across.size());
    if (!(ray.count > 0.0)) ray.add(image.across[middle], image.forward[middle]);
    const double length = image.planar_rows ? ray.count : std::hypot(ray.x, ray.z);
    blocks_.across[c] = length > 0.0 ? ray.x / length : 0.0;
    blocks_.forward[c] = length > 0.0 ? ray.z / length : 0.0;
    squares += ray.squaresAbout(blocks_.across[c], blocks_.forward[c]);
  }
  blocks_.place_of_pixel = image.placeVariance();
  blocks_.place_beside = samples > 0.0 ? 0.5 * squares / samples : 0.0;
}

}  // namespace epcc
