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

bool same(const Rgb& a, const Rgb& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

TEST(SegmentPicture, SegmentsOfAPlaneHaveItsColourAndADarkEnd) {
  const DepthImage depth(20, 10, 2.0F);
  const ColorImage image =
      drawSegments(depth, {segment(ScanDirection::Columns, 6, 1, 4, 3), segment(ScanDirection::Rows, 0, 12, 15, 2)});
  for (int i = 1; i < 4; ++i) EXPECT_TRUE(same(image.at(i, 6), labelColor(3)));
  for (int i = 12; i < 15; ++i) EXPECT_TRUE(same(image.at(0, i), labelColor(2)));
  EXPECT_LT(image.at(4, 6).r, 30);
  EXPECT_LT(image.at(0, 15).r, 30);
  const Rgb relief = shadeDepth(depth).at(5, 6);
  EXPECT_EQ(image.at(5, 6).r, relief.r / 2);
}

TEST(SegmentPicture, SegmentsOfNoPlaneTakeTurns) {
  const ColorImage image = drawSegments(DepthImage(10, 30, 2.0F), {segment(ScanDirection::Columns, 0, 0, 5, 0),
                                                                   segment(ScanDirection::Columns, 0, 6, 9, 0)});
  EXPECT_TRUE(same(image.at(0, 0), {255, 255, 255}));
  EXPECT_TRUE(same(image.at(6, 0), {0, 0, 0}));
}

TEST(SegmentPicture, LinesBetweenAreLeftOut) {
  const DepthImage depth(20, 10, 2.0F);
  const ColorImage none = drawSegments(depth, {});
  const ColorImage image = drawSegments(depth, {segment(ScanDirection::Columns, 7, 1, 4, 3)});
  for (std::size_t i = 0; i < image.data.size(); ++i) EXPECT_TRUE(same(image.data[i], none.data[i]));
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
