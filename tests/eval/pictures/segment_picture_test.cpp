// SPDX-License-Identifier: BSD-3-Clause
// Colours of line segments by column and by row.
#include "eval/pictures/segment_picture.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "eval/pictures/label_colors.h"
#include "eval/pictures/overlay.h"

namespace epcc {
namespace {

LineSegment segment(ScanDirection scan, int line, int first, int last, int label) {
  LineSegment made;
  made.scan = scan;
  made.line = line;
  made.first = first;
  made.last = last;
  made.label = label;
  return made;
}

bool sameColor(const Rgb& a, const Rgb& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

TEST(SegmentPicture, SegmentsOfAPlaneHaveItsColourAndADarkEnd) {
  const DepthImage depth(20, 10, 2.0F);
  const ColorImage image =
      drawSegments(depth, {segment(ScanDirection::Columns, 6, 1, 4, 3), segment(ScanDirection::Rows, 0, 12, 15, 2)});
  for (int i = 1; i < 4; ++i) EXPECT_TRUE(sameColor(image.at(i, 6), labelColor(3)));
  for (int i = 12; i < 15; ++i) EXPECT_TRUE(sameColor(image.at(0, i), labelColor(2)));
  EXPECT_LT(image.at(4, 6).r, 30);
  EXPECT_LT(image.at(0, 15).r, 30);
  const Rgb relief = shadeDepth(depth).at(5, 6);
  EXPECT_EQ(image.at(5, 6).r, relief.r / 2);
}

TEST(SegmentPicture, SegmentsOfNoPlaneTakeTurns) {
  const ColorImage image = drawSegments(DepthImage(10, 30, 2.0F), {segment(ScanDirection::Columns, 0, 0, 5, 0),
                                                                   segment(ScanDirection::Columns, 0, 6, 9, 0)});
  EXPECT_TRUE(sameColor(image.at(0, 0), {255, 255, 255}));
  EXPECT_TRUE(sameColor(image.at(6, 0), {0, 0, 0}));
}

TEST(SegmentPicture, LinesBetweenAreLeftOut) {
  const DepthImage depth(20, 10, 2.0F);
  std::vector<LineSegment> all;
  for (int line = 0; line < 20; ++line) all.push_back(segment(ScanDirection::Columns, line, 1, 4, 3));
  const ColorImage image = drawSegments(depth, all);
  for (int line = 0; line < 20; ++line) EXPECT_EQ(sameColor(image.at(2, line), labelColor(3)), line % 6 == 0) << line;
}

/// A grid has columns 1, 3, 5 ... or 2, 6, 10 ...: every sixth column of the image may be none of them.
TEST(SegmentPicture, ScanLinesOfAGridAreDrawnWhereverTheyLie) {
  const DepthImage depth(40, 40, 2.0F);
  for (const int stride : {2, 3, 4}) {
    std::vector<LineSegment> all;
    for (const ScanDirection scan : {ScanDirection::Columns, ScanDirection::Rows})
      for (int line = stride / 2; line < 40; line += stride) all.push_back(segment(scan, line, 0, 30, 3));
    const ColorImage image = drawSegments(depth, all);
    const int step = stride == 4 ? 8 : 6;
    for (int line = 0; line < 40; ++line) {
      const bool drawn = line % step == stride / 2;
      EXPECT_EQ(sameColor(image.at(0, line), labelColor(3)), drawn) << stride << ' ' << line;
      EXPECT_EQ(sameColor(image.at(line, 0), labelColor(3)), drawn) << stride << ' ' << line;
    }
  }
}

TEST(SegmentPicture, SegmentsOutsideAreRefused) {
  const DepthImage depth(20, 10, 2.0F);
  for (const LineSegment& outside :
       {segment(ScanDirection::Columns, 20, 1, 4, 3), segment(ScanDirection::Columns, 0, 1, 10, 3),
        segment(ScanDirection::Rows, 10, 1, 4, 3), segment(ScanDirection::Rows, 0, -1, 4, 3),
        segment(ScanDirection::Rows, 0, 5, 4, 3)})
    EXPECT_THROW(drawSegments(depth, {outside}), std::invalid_argument);
}

}  // namespace
}  // namespace epcc
