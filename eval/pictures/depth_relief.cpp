// SPDX-License-Identifier: BSD-3-Clause
// Lights the slope of the inverse depth, which is constant on a plane: each plane gets one shade.
#include "eval/pictures/depth_relief.h"

#include <algorithm>
#include <cmath>

#include "datasets/support/quantile.h"

namespace epcc {
namespace {

constexpr int kSmoothRadius = 3;        // pixels; depth noise would show as grain
constexpr int kGradientStep = 2;        // pixels
constexpr double kSameSurface = 0.04;   // relative step of inverse depth within a surface
constexpr double kFocalPerSize = 0.95;  // focal length guessed from the larger side

struct InverseDepth {
  int width;
  int height;
  std::vector<float> w;  // 1/m, 0 = invalid

  float at(int row, int column) const {
    if (row < 0 || row >= height || column < 0 || column >= width) return 0.0F;
    return w[static_cast<std::size_t>(row) * width + column];
  }
};

bool sameSurface(double a, double b) {
  return b > 0.0 && std::abs(a - b) < kSameSurface * a;
}

InverseDepth invert(const DepthImage& depth) {
  InverseDepth result{depth.width, depth.height, std::vector<float>(depth.data.size(), 0.0F)};
  for (std::size_t i = 0; i < depth.data.size(); ++i) {
    const float z = depth.data[i];
    if (std::isfinite(z) && z > 0.0F) result.w[i] = 1.0F / z;
  }
  return result;
}

// Mean along one direction over the neighbours on the same surface.
InverseDepth smooth(const InverseDepth& source, int row_step, int column_step) {
  InverseDepth result = source;
  for (int row = 0; row < source.height; ++row) {
    for (int column = 0; column < source.width; ++column) {
      const double centre = source.at(row, column);
      if (centre <= 0.0) continue;
      double sum = 0.0;
      int count = 0;
      for (int k = -kSmoothRadius; k <= kSmoothRadius; ++k) {
        const double w = source.at(row + k * row_step, column + k * column_step);
        if (!sameSurface(centre, w)) continue;
        sum += w;
        ++count;
      }
      if (count > 0) result.w[static_cast<std::size_t>(row) * source.width + column] = static_cast<float>(sum / count);
    }
  }
  return result;
}

// Slope per pixel along one direction, central where both neighbours are on the surface.
double slope(const InverseDepth& image, int row, int column, int row_step, int column_step) {
  const double centre = image.at(row, column);
  const double after = image.at(row + kGradientStep * row_step, column + kGradientStep * column_step);
  const double before = image.at(row - kGradientStep * row_step, column - kGradientStep * column_step);
  const bool has_after = sameSurface(centre, after);
  const bool has_before = sameSurface(centre, before);
  if (has_after && has_before) return (after - before) / (2.0 * kGradientStep);
  if (has_after) return (after - centre) / kGradientStep;
  if (has_before) return (centre - before) / kGradientStep;
  return 0.0;
}

// w = -(n . ray) / d: the slopes of w and its value give the normal up to scale.
double lit(const InverseDepth& image, int row, int column) {
  const double focal = kFocalPerSize * std::max(image.width, image.height);
  const double gx = slope(image, row, column, 0, 1);
  const double gy = slope(image, row, column, 1, 0);
  const double nx = -gx * focal;
  const double ny = -gy * focal;
  const double nz = -(image.at(row, column) - gx * (column - 0.5 * image.width) - gy * (row - 0.5 * image.height));
  const double norm = std::sqrt(nx * nx + ny * ny + nz * nz);
  if (!(norm > 0.0)) return 0.5;
  // Light from the upper left, behind the camera.
  const double cosine = (-0.40 * nx - 0.65 * ny - 0.65 * nz) / (norm * 1.0025);
  return 0.5 + 0.5 * cosine;
}

}  // namespace

std::vector<float> depthRelief(const DepthImage& depth) {
  const InverseDepth raw = invert(depth);
  const InverseDepth image = smooth(smooth(raw, 0, 1), 1, 0);
  std::vector<float> valid;
  std::copy_if(raw.w.begin(), raw.w.end(), std::back_inserter(valid), [](float w) { return w > 0.0F; });
  std::vector<float> relief(depth.data.size(), -1.0F);
  if (valid.empty()) return relief;
  const double far = quantile(valid, 0.02);
  const double range = std::max(quantile(valid, 0.98) - far, 1e-9);
  for (int row = 0; row < depth.height; ++row) {
    for (int column = 0; column < depth.width; ++column) {
      if (image.at(row, column) <= 0.0F) continue;
      const double nearness = std::clamp((image.at(row, column) - far) / range, 0.0, 1.0);
      const double brightness = lit(image, row, column) * (0.70 + 0.30 * nearness);
      relief[static_cast<std::size_t>(row) * depth.width + column] =
          static_cast<float>(std::clamp(brightness, 0.0, 1.0));
    }
  }
  return relief;
}

}  // namespace epcc
