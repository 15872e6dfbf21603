// SPDX-License-Identifier: BSD-3-Clause
// Grids of pictures: sizes, places, captions.
#include "eval/pictures/mosaic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "eval/pictures/bitmap_font.h"

namespace {

using epcc::ColorImage;
using epcc::Mosaic;
using epcc::MosaicStyle;
using epcc::Rgb;

ColorImage flat(int width, int height, const Rgb& color) {
  ColorImage image;
  image.width = width;
  image.height = height;
  image.data.assign(static_cast<std::size_t>(width) * height, color);
  return image;
}

const Rgb& at(const ColorImage& image, int x, int y) {
  return image.data[static_cast<std::size_t>(y) * image.width + x];
}

bool same(const Rgb& a, const Rgb& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

long count(const ColorImage& image, const Rgb& color) {
  return std::count_if(image.data.begin(), image.data.end(), [&](const Rgb& pixel) { return same(pixel, color); });
}

constexpr Rgb kRed{200, 0, 0};
constexpr Rgb kBlue{0, 0, 200};

MosaicStyle smallStyle() {
  MosaicStyle style;
  style.cell_width = 20;
  style.gap = 4;
  style.text_scale = 1;
  return style;
}

TEST(Mosaic, PutsPicturesSideBySide) {
  Mosaic mosaic;
  mosaic.rows = {{flat(20, 10, kRed), flat(20, 10, kBlue)}, {flat(20, 10, kBlue)}};
  const ColorImage image = drawMosaic(mosaic, smallStyle());
  EXPECT_EQ(image.width, 4 + 20 + 4 + 20 + 4);
  EXPECT_EQ(image.height, 4 + 10 + 4 + 10 + 4);
  EXPECT_TRUE(same(at(image, 4, 4), kRed));
  EXPECT_TRUE(same(at(image, 28, 13), kBlue));
  EXPECT_TRUE(same(at(image, 4, 18), kBlue));
  EXPECT_TRUE(same(at(image, 28, 18), Rgb{255, 255, 255}));
  EXPECT_TRUE(same(at(image, 25, 5), Rgb{255, 255, 255}));
}

TEST(Mosaic, ScalesPicturesToTheCell) {
  Mosaic mosaic;
  mosaic.rows = {{flat(40, 20, kRed), flat(5, 10, kBlue)}};
  const ColorImage image = drawMosaic(mosaic, smallStyle());
  EXPECT_EQ(count(image, kRed), 20 * 10);
  EXPECT_EQ(count(image, kBlue), 20 * 40);
}

TEST(Mosaic, CaptionsTakeTheirOwnSpace) {
  Mosaic plain;
  plain.rows = {{flat(20, 30, kRed)}};
  Mosaic captioned = plain;
  captioned.column_captions = {"A"};
  captioned.row_captions = {"B"};
  const ColorImage without = drawMosaic(plain, smallStyle());
  const ColorImage with = drawMosaic(captioned, smallStyle());
  EXPECT_EQ(with.width, without.width + 7 + 4);
  EXPECT_EQ(with.height, without.height + 7 + 4);
  EXPECT_EQ(count(with, kRed), 600);
  EXPECT_EQ(count(without, smallStyle().text), 0);
  EXPECT_GT(count(with, smallStyle().text), 20);
}

TEST(Mosaic, EmptyPicturesLeaveTheirCellBlank) {
  Mosaic mosaic;
  mosaic.rows = {{ColorImage(), flat(20, 10, kRed)}, {}};
  const ColorImage image = drawMosaic(mosaic, smallStyle());
  EXPECT_EQ(count(image, kRed), 200);
}

TEST(Mosaic, NothingToShowIsAnEmptyMargin) {
  const ColorImage image = drawMosaic(Mosaic(), smallStyle());
  EXPECT_EQ(image.width, 4);
  EXPECT_EQ(image.height, 4);
  EXPECT_EQ(count(image, smallStyle().background), 16);
}

TEST(Mosaic, RefusesBadStyle) {
  MosaicStyle style;
  style.cell_width = 0;
  EXPECT_THROW(drawMosaic(Mosaic(), style), std::invalid_argument);
}

TEST(Resize, AveragesWhenSmaller) {
  ColorImage image = flat(2, 1, kRed);
  image.data[1] = kBlue;
  const ColorImage half = epcc::resize(image, 1, 1);
  EXPECT_TRUE(same(half.data[0], Rgb{100, 0, 100}));
}

TEST(BitmapFont, DrawsRightAndUp) {
  ColorImage right = flat(40, 40, Rgb{});
  ColorImage up = flat(40, 40, Rgb{});
  epcc::drawText(right, "L1", 2, 3, 1, kRed);
  epcc::drawText(up, "L1", 2, 30, 1, kRed, epcc::TextDirection::Up);
  EXPECT_EQ(count(right, kRed), count(up, kRed));
  for (int i = 0; i < 7; ++i) EXPECT_TRUE(same(at(right, 2, 3 + i), kRed)) << "the stem of L goes down";
  for (int i = 0; i < 7; ++i) EXPECT_TRUE(same(at(up, 2 + i, 30), kRed)) << "turned, it goes right";
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(same(at(up, 8, 30 - i), kRed)) << "and its foot up";
}

TEST(BitmapFont, StaysInsideTheImage) {
  ColorImage image = flat(8, 8, Rgb{});
  epcc::drawText(image, "WIDE \x01\xff text", -3, 5, 2, kRed);
  epcc::drawText(image, "WIDE", 5, -2, 3, kRed, epcc::TextDirection::Up);
  EXPECT_EQ(image.data.size(), 64U);
}

TEST(BitmapFont, LengthCountsGapsBetweenGlyphs) {
  EXPECT_EQ(epcc::textLength("", 2), 0);
  EXPECT_EQ(epcc::textLength("A", 2), 10);
  EXPECT_EQ(epcc::textLength("AB", 1), 11);
}

}  // namespace
