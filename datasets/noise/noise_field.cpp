// SPDX-License-Identifier: BSD-3-Clause
// Correlated noise is white noise smoothed by a Gaussian of the width that gives the correlation length asked for.
#include "datasets/noise/noise_field.h"

#include <cmath>
#include <limits>

#include "datasets/support/quantile.h"

namespace epcc {
namespace {

Image<float> whiteField(int width, int height, SceneRandom& random) {
  Image<float> field(width, height);
  for (float& value : field.data) value = static_cast<float>(random.normal());
  return field;
}

// Kernel of unit energy: smoothing white noise with it keeps the variance.
std::vector<float> kernelOf(double length) {
  const double width = length / std::sqrt(2.0);  // the autocorrelation of the result is sqrt(2) wider than the kernel
  const int radius = static_cast<int>(std::ceil(3.0 * width));
  std::vector<double> taps;
  double energy = 0.0;
  for (int i = -radius; i <= radius; ++i) {
    taps.push_back(std::exp(-0.5 * i * i / (width * width)));
    energy += taps.back() * taps.back();
  }
  std::vector<float> kernel;
  for (const double tap : taps) kernel.push_back(static_cast<float>(tap / std::sqrt(energy)));
  return kernel;
}

// Both keep only where the kernel fits.
Image<float> smoothRows(const Image<float>& in, const std::vector<float>& kernel) {
  Image<float> out(in.width - static_cast<int>(kernel.size()) + 1, in.height);
  for (int row = 0; row < out.height; ++row) {
    float* to = &out.at(row, 0);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const float* from = &in.at(row, static_cast<int>(k));
      for (int column = 0; column < out.width; ++column) to[column] += kernel[k] * from[column];
    }
  }
  return out;
}

Image<float> smoothColumns(const Image<float>& in, const std::vector<float>& kernel) {
  Image<float> out(in.width, in.height - static_cast<int>(kernel.size()) + 1);
  for (int row = 0; row < out.height; ++row) {
    float* to = &out.at(row, 0);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const float* from = &in.at(row + static_cast<int>(k), 0);
      for (int column = 0; column < out.width; ++column) to[column] += kernel[k] * from[column];
    }
  }
  return out;
}

}  // namespace

Image<float> noiseField(int width, int height, double length, SceneRandom& random) {
  if (length < 0.5) return whiteField(width, height, random);
  const std::vector<float> kernel = kernelOf(length);
  const int margin = static_cast<int>(kernel.size()) - 1;
  return smoothColumns(smoothRows(whiteField(width + margin, height + margin, random), kernel), kernel);
}

float upperQuantile(const Image<float>& image, double share) {
  const auto above = static_cast<std::size_t>(std::lround(share * static_cast<double>(image.data.size())));
  if (above == 0) return std::numeric_limits<float>::infinity();
  if (above >= image.data.size()) return -std::numeric_limits<float>::infinity();
  return valueOfRank(image.data, image.data.size() - 1 - above);
}

}  // namespace epcc
