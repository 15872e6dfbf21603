// SPDX-License-Identifier: BSD-3-Clause
// The relief shows geometry, the overlay shows labels, and neither minds odd depth.
#include "eval/pictures/overlay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "eval/pictures/label_colors.h"

namespace {

using epcc::ColorImage;
using epcc::DepthImage;
using epcc::Rgb;

DepthImage depthImage(int width, int height, float metres) {
  DepthImage depth;
  depth.width = width;
  depth.height = height;
  depth.data.assign(static_cast<std::size_t>(width) * height, metres);
  return depth;
}

bool isGrey(const Rgb& pixel) {
  return pixel.r == pixel.g && pixel.g == pixel.b;
}

// Left half faces left, right half faces right.
DepthImage roof(int width, int height) {
  DepthImage depth = depthImage(width, height, 0.0F);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double w = 0.5 - 0.2 * std::abs(column - width / 2) / width;
      depth.data[static_cast<std::size_t>(row) * width + column] = static_cast<float>(1.0 / w);
    }
  }
  return depth;
}

TEST(Overlay, KeepsTheSize) {
  const ColorImage image = epcc::shadeDepth(depthImage(17, 9, 1.5F));
  EXPECT_EQ(image.width, 17);
  EXPECT_EQ(image.height, 9);
  EXPECT_EQ(image.data.size(), 17U * 9U);
}

TEST(Overlay, FacesOfARoofHaveDifferentShades) {
  const ColorImage image = epcc::shadeDepth(roof(80, 40));
  const Rgb left = image.data[20 * 80 + 20];
  const Rgb right = image.data[20 * 80 + 60];
  EXPECT_TRUE(isGrey(left));
  EXPECT_GT(std::abs(left.r - right.r), 10);
}

TEST(Overlay, OneFaceHasOneShade) {
  const ColorImage image = epcc::shadeDepth(roof(80, 40));
  EXPECT_NEAR(image.data[10 * 80 + 15].r, image.data[30 * 80 + 15].r, 2);
}

TEST(Overlay, InvalidPixelsAreDark) {
  DepthImage depth = depthImage(20, 20, 2.0F);
  depth.data[0] = 0.0F;
  depth.data[1] = std::numeric_limits<float>::quiet_NaN();
  depth.data[2] = std::numeric_limits<float>::infinity();
  depth.data[3] = -1.0F;
  const ColorImage image = epcc::shadeDepth(depth);
  for (int i = 0; i < 4; ++i) EXPECT_LT(image.data[static_cast<std::size_t>(i)].r, 30) << i;
  EXPECT_GT(image.data[100].r, 60);
}

TEST(Overlay, AFrameWithoutDepthIsDark) {
  const ColorImage image = epcc::shadeDepth(depthImage(5, 5, 0.0F));
  for (const Rgb& pixel : image.data) EXPECT_LT(pixel.r, 30);
}

TEST(Overlay, LabelsAreColouredAndTheRestStaysGrey) {
  const DepthImage depth = depthImage(30, 30, 2.0F);
  std::vector<std::int32_t> labels(900, 0);
  for (std::size_t i = 0; i < 450; ++i) labels[i] = 1;
  const ColorImage image = epcc::drawOverlay(depth, labels);
  EXPECT_FALSE(isGrey(image.data[100]));
  EXPECT_TRUE(isGrey(image.data[800]));
}

TEST(Overlay, OpacityZeroIsTheRelief) {
  const DepthImage depth = roof(30, 20);
  epcc::OverlayStyle style;
  style.opacity = 0.0;
  style.borders = false;
  const ColorImage image = epcc::drawOverlay(depth, std::vector<std::int32_t>(600, 3), style);
  const ColorImage relief = epcc::shadeDepth(depth);
  for (std::size_t i = 0; i < relief.data.size(); ++i) EXPECT_EQ(image.data[i].g, relief.data[i].g);
}

TEST(Overlay, BordersAreDarkerThanTheRegions) {
  std::vector<std::int32_t> labels(900, 1);
  for (std::size_t i = 450; i < 900; ++i) labels[i] = 2;
  const ColorImage image = epcc::drawOverlay(depthImage(30, 30, 2.0F), labels);
  const auto sum = [&](std::size_t i) { return image.data[i].r + image.data[i].g + image.data[i].b; };
  EXPECT_LT(2 * sum(14 * 30 + 10), sum(10 * 30 + 10));
  EXPECT_EQ(sum(12 * 30 + 10), sum(10 * 30 + 10));
}

TEST(Overlay, TakesALabelImage) {
  epcc::LabelImage labels;
  labels.width = labels.height = 10;
  labels.data.assign(100, epcc::kIgnoreLabel);
  const ColorImage image = epcc::drawOverlay(depthImage(10, 10, 1.0F), labels);
  EXPECT_TRUE(isGrey(image.data[55]));
}

TEST(Overlay, RefusesLabelsOfAnotherSize) {
  EXPECT_THROW(epcc::drawOverlay(depthImage(4, 4, 1.0F), std::vector<std::int32_t>(15)), std::invalid_argument);
}

TEST(Overlay, AnEmptyImageIsEmpty) {
  EXPECT_TRUE(epcc::shadeDepth(DepthImage()).data.empty());
}

}  // namespace
