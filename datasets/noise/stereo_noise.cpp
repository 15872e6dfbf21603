// SPDX-License-Identifier: BSD-3-Clause
// Each step works on the inverse depth w = 1/z, which is proportional to the disparity; 0 = invalid.
#include "datasets/noise/stereo_noise.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "datasets/noise/noise_field.h"
#include "datasets/support/scene_random.h"

namespace epcc {
namespace {

// Streams of random numbers, one a step: a change of one step leaves the others as they are.
enum Stream : std::uint64_t { kError = 101, kWhite, kEdges, kFlying, kOutliers, kHoles };

constexpr float kJump = 0.04F;            // relative second difference of w that makes an edge
constexpr double kMaxMatchedSlant2 = 25;  // tan^2
constexpr double kMaxDepth = 65.0;        // metres, the most that 16 bits of a millimetre hold

Image<float> inverted(const DepthImage& depth) {
  Image<float> w(depth.width, depth.height);
  for (std::size_t i = 0; i < w.data.size(); ++i)
    if (depth.data[i] > 0.0F && std::isfinite(depth.data[i])) w.data[i] = 1.0F / depth.data[i];
  return w;
}

// Difference along a line, the smaller of both sides: unharmed by an edge on one of them.
float gentleDifference(float before, float here, float after) {
  const float back = before > 0.0F ? here - before : std::numeric_limits<float>::max();
  const float ahead = after > 0.0F ? after - here : std::numeric_limits<float>::max();
  const float gentle = std::fabs(back) < std::fabs(ahead) ? back : ahead;
  return std::fabs(gentle) < std::numeric_limits<float>::max() ? gentle : 0.0F;
}

float valueOr0(const Image<float>& image, int row, int column) {
  const bool inside = row >= 0 && column >= 0 && row < image.height && column < image.width;
  return inside ? image.at(row, column) : 0.0F;
}

bool bends(float before, float here, float after) {
  return before > 0.0F && here > 0.0F && after > 0.0F && std::fabs(before - 2.0F * here + after) > kJump * here;
}

// 1 within `reach` pixels of a jump in depth.
Image<std::uint8_t> nearJumps(const Image<float>& w, int reach) {
  Image<std::uint8_t> near(w.width, w.height);
  for (int row = 0; row < w.height; ++row) {
    for (int column = 0; column < w.width; ++column) {
      const float here = w.at(row, column);
      if (!bends(valueOr0(w, row, column - 1), here, valueOr0(w, row, column + 1)) &&
          !bends(valueOr0(w, row - 1, column), here, valueOr0(w, row + 1, column)))
        continue;
      for (int r = std::max(0, row - reach); r <= std::min(w.height - 1, row + reach); ++r)
        for (int c = std::max(0, column - reach); c <= std::min(w.width - 1, column + reach); ++c) near.at(r, c) = 1;
    }
  }
  return near;
}

// Shifts the edges back and forth by a smooth random displacement.
Image<float> wobbled(const Image<float>& w, const StereoNoise& noise, std::uint64_t seed) {
  SceneRandom random(seed, kEdges);
  const double scale = noise.grid_scale;
  const auto reach = static_cast<int>(std::ceil(2.0 * noise.edge_wobble * scale));
  const Image<std::uint8_t> near = nearJumps(w, reach);
  const Image<float> across = noiseField(w.width, w.height, 2.5 * scale, random);
  const Image<float> down = noiseField(w.width, w.height, 2.5 * scale, random);
  Image<float> result = w;
  const auto step = [&](float value) { return static_cast<int>(std::lround(value * noise.edge_wobble * scale)); };
  for (int row = 0; row < w.height; ++row) {
    for (int column = 0; column < w.width; ++column) {
      if (near.at(row, column) == 0 || w.at(row, column) <= 0.0F) continue;
      const float moved = valueOr0(w, row + step(down.at(row, column)), column + step(across.at(row, column)));
      if (moved > 0.0F) result.at(row, column) = moved;
    }
  }
  return result;
}

// Some pixels at a jump take a depth between both sides.
void addFlyingPixels(Image<float>& w, const StereoNoise& noise, std::uint64_t seed) {
  SceneRandom random(seed, kFlying);
  const Image<std::uint8_t> near = nearJumps(w, 0);
  const Image<float> before = w;
  for (int row = 0; row < w.height; ++row) {
    for (int column = 0; column < w.width; ++column) {
      const double chance = random.uniform(), between = random.uniform();
      if (near.at(row, column) == 0 || chance >= noise.flying_share) continue;
      float low = before.at(row, column), high = low;
      for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = column - 1; c <= column + 1; ++c) {
          const float value = valueOr0(before, r, c);
          if (value <= 0.0F) continue;
          low = std::min(low, value);
          high = std::max(high, value);
        }
      }
      w.at(row, column) = low + static_cast<float>(between) * (high - low);
    }
  }
}

// The second imager stands to the right: it sees a point `disparity` pixels further left. A point is hidden if another
// one further right lands on the same place or left of it.
Image<std::uint8_t> hiddenFromSecond(const Image<float>& w, double pixels_per_w, bool native) {
  Image<std::uint8_t> hidden(w.width, w.height);
  for (int row = 0; row < w.height; ++row) {
    double leftmost = std::numeric_limits<double>::infinity();
    for (int column = w.width - 1; column >= 0; --column) {
      const float here = w.at(row, column);
      if (here <= 0.0F) continue;
      const double place = column - pixels_per_w * static_cast<double>(here);
      // Half a pixel of tolerance: slanted surfaces crowd in the second image without hiding themselves.
      if (place > leftmost + 0.5 || (native && place < 0.0)) hidden.at(row, column) = 1;
      leftmost = std::min(leftmost, place);
    }
  }
  return hidden;
}

// Blotches of several sizes and a white part, unit variance in all.
Image<float> unitError(int width, int height, const StereoNoise& noise, std::uint64_t seed) {
  SceneRandom random(seed, kError);
  const double length = noise.blotch * noise.grid_scale;
  const double main_share = 1.0 - noise.white_share - noise.small_share - noise.slow_share;
  Image<float> sum(width, height);
  const auto add = [&](double share, double field_length) {
    const Image<float> field = noiseField(width, height, field_length, random);
    const auto weight = static_cast<float>(std::sqrt(std::max(0.0, share)));
    for (std::size_t i = 0; i < sum.data.size(); ++i) sum.data[i] += weight * field.data[i];
  };
  add(main_share, length);
  add(noise.small_share, length / 3.0);
  add(noise.slow_share, length * 3.0);
  add(noise.white_share, 0.0);
  return sum;
}

// The given share of the pixels in smooth blobs; `bias` (may be empty) makes them more likely where it is large.
Image<std::uint8_t> blobs(int width, int height, double length, double share, const Image<float>& bias,
                          SceneRandom& random) {
  Image<float> field = noiseField(width, height, length, random);
  for (std::size_t i = 0; i < bias.data.size(); ++i) field.data[i] += bias.data[i];
  const float least = upperQuantile(field, share);
  Image<std::uint8_t> mask(width, height);
  for (std::size_t i = 0; i < field.data.size(); ++i) mask.data[i] = field.data[i] > least ? 1 : 0;
  return mask;
}

void addErrors(Image<float>& w, const Image<float>& slant, const StereoNoise& noise, std::uint64_t seed) {
  const Image<float> error = unitError(w.width, w.height, noise, seed);
  SceneRandom random(seed, kOutliers);
  const auto wrong = blobs(w.width, w.height, 1.2 * noise.grid_scale, noise.outlier_share, {}, random);
  const Image<float> wrong_by = noiseField(w.width, w.height, 2.0 * noise.grid_scale, random);
  for (std::size_t i = 0; i < w.data.size(); ++i) {
    if (w.data[i] <= 0.0F) continue;
    const double value = w.data[i];
    const double sigma = std::hypot(noise.sigma_w, noise.sigma_floor * value * value) * slant.data[i];
    const double by = wrong_by.data[i];
    const double outlier = wrong.data[i] != 0 ? (by < 0.0 ? -5.0 : 5.0) + 4.0 * by : 0.0;  // in sigma
    w.data[i] = static_cast<float>(value + sigma * (static_cast<double>(error.data[i]) + outlier));
  }
}

// Holes are more likely where the surface is slanted or near, as on real frames.
void punchHoles(Image<float>& w, const Image<float>& slant, const StereoNoise& noise, std::uint64_t seed) {
  SceneRandom random(seed, kHoles);
  Image<float> bias(w.width, w.height);
  for (std::size_t i = 0; i < w.data.size(); ++i)
    if (w.data[i] > 0.0F) bias.data[i] = 0.3F * (slant.data[i] - 1.0F) + 0.6F * std::min(w.data[i], 4.0F);
  const auto specks = blobs(w.width, w.height, 1.2 * noise.grid_scale, 0.5 * noise.hole_share, bias, random);
  const auto patches = blobs(w.width, w.height, 6.0 * noise.grid_scale, 0.5 * noise.hole_share, bias, random);
  for (std::size_t i = 0; i < w.data.size(); ++i)
    if (specks.data[i] != 0 || patches.data[i] != 0) w.data[i] = 0.0F;
}

// Steps of the disparity, then whole millimetres.
DepthImage quantised(const Image<float>& w, double native_pixels_per_w, double step) {
  DepthImage depth(w.width, w.height);
  for (std::size_t i = 0; i < w.data.size(); ++i) {
    const double disparity = step * std::round(native_pixels_per_w * static_cast<double>(w.data[i]) / step);
    if (disparity <= 0.0) continue;
    const double z = native_pixels_per_w / disparity;
    if (z < kMaxDepth) depth.data[i] = static_cast<float>(0.001 * std::round(1000.0 * z));
  }
  return depth;
}

}  // namespace

Image<float> slantFactors(const Image<float>& w, const PinholeCamera& camera) {
  Image<float> factors(w.width, w.height);
  for (int row = 0; row < w.height; ++row) {
    for (int column = 0; column < w.width; ++column) {
      const float here = w.at(row, column);
      if (here <= 0.0F) continue;
      const float across = gentleDifference(valueOr0(w, row, column - 1), here, valueOr0(w, row, column + 1));
      const float down = gentleDifference(valueOr0(w, row - 1, column), here, valueOr0(w, row + 1, column));
      const double qu = camera.fx * static_cast<double>(across), qv = camera.fy * static_cast<double>(down);
      const double tan2 = (qu * qu + qv * qv) / (static_cast<double>(here) * here);
      factors.at(row, column) = static_cast<float>(std::sqrt(1.0 + std::min(kMaxMatchedSlant2, tan2)));
    }
  }
  return factors;
}

DepthImage stereoDepth(const DepthImage& depth, const PinholeCamera& camera, const StereoNoise& noise,
                       std::uint64_t seed) {
  const double pixels_per_w = camera.fx * noise.baseline;
  Image<float> w = wobbled(inverted(depth), noise, seed);
  const Image<float> slant = slantFactors(w, camera);
  const auto hidden = hiddenFromSecond(w, pixels_per_w, noise.grid_scale == 1.0);
  addFlyingPixels(w, noise, seed);
  addErrors(w, slant, noise, seed);
  punchHoles(w, slant, noise, seed);
  if (noise.shadows)
    for (std::size_t i = 0; i < w.data.size(); ++i)
      if (hidden.data[i] != 0) w.data[i] = 0.0F;
  return quantised(w, pixels_per_w / noise.grid_scale, noise.disparity_step);
}

}  // namespace epcc
