// SPDX-License-Identifier: BSD-3-Clause
// Blends label colours with the depth relief and draws the borders of the regions.
#include "eval/pictures/overlay.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "eval/pictures/depth_relief.h"
#include "eval/pictures/label_colors.h"

namespace epcc {
namespace {

constexpr Rgb kInvalid{18, 18, 22};
constexpr double kBorderDarkening = 0.25;

std::uint8_t toByte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

Rgb grey(float brightness) {
  const std::uint8_t level = toByte(35.0 + 205.0 * brightness);
  return Rgb{level, level, level};
}

// The colour takes the relief's light: edges stay visible inside a region.
Rgb blend(const Rgb& base, const Rgb& color, float brightness, double opacity) {
  const double light = 0.35 + 0.75 * brightness;
  const auto mix = [&](std::uint8_t from, std::uint8_t to) {
    return toByte((1.0 - opacity) * from + opacity * light * to);
  };
  return Rgb{mix(base.r, color.r), mix(base.g, color.g), mix(base.b, color.b)};
}

bool isBorder(const std::vector<std::int32_t>& labels, int width, int height, int row, int column) {
  const std::size_t i = static_cast<std::size_t>(row) * width + column;
  const auto differs = [&](std::size_t other) { return labels[i] != labels[other]; };
  return (column + 1 < width && differs(i + 1)) || (row + 1 < height && differs(i + static_cast<std::size_t>(width)));
}

void darkenBorders(const std::vector<std::int32_t>& labels, ColorImage& image) {
  const auto darker = [](std::uint8_t value) { return toByte(kBorderDarkening * value); };
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      if (!isBorder(labels, image.width, image.height, row, column)) continue;
      Rgb& pixel = image.data[static_cast<std::size_t>(row) * image.width + column];
      pixel = Rgb{darker(pixel.r), darker(pixel.g), darker(pixel.b)};
    }
  }
}

}  // namespace

ColorImage shadeDepth(const DepthImage& depth) {
  ColorImage image(depth.width, depth.height, kInvalid);
  const std::vector<float> relief = depthRelief(depth);
  for (std::size_t i = 0; i < relief.size(); ++i) {
    if (relief[i] >= 0.0F) image.data[i] = grey(relief[i]);
  }
  return image;
}

ColorImage drawOverlay(const DepthImage& depth, const std::vector<std::int32_t>& labels, const OverlayStyle& style) {
  if (labels.size() != depth.data.size()) throw std::invalid_argument("labels and depth differ in size");
  ColorImage image(depth.width, depth.height, kInvalid);
  const std::vector<float> relief = depthRelief(depth);
  for (std::size_t i = 0; i < relief.size(); ++i) {
    const float brightness = std::max(relief[i], 0.0F);
    if (relief[i] >= 0.0F) image.data[i] = grey(brightness);
    if (labels[i] > 0) image.data[i] = blend(image.data[i], labelColor(labels[i]), brightness, style.opacity);
  }
  if (style.borders) darkenBorders(labels, image);
  return image;
}

ColorImage drawOverlay(const DepthImage& depth, const LabelImage& labels, const OverlayStyle& style) {
  return drawOverlay(depth, std::vector<std::int32_t>(labels.data.begin(), labels.data.end()), style);
}

}  // namespace epcc
