// SPDX-License-Identifier: BSD-3-Clause
// Border tracing: hand-made regions, and random label images against flood fill and winding numbers.
#include "epcc_segmentation/contours.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace epcc {
namespace {

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::int32_t> labels;
  std::int32_t at(int column, int row) const {
    if (column < 0 || column >= width || row < 0 || row >= height) return 0;
    return labels[static_cast<std::size_t>(row * width + column)];
  }
};

/// One string a row; '.' is 0, digits are labels.
Picture draw(const std::vector<std::string>& rows) {
  Picture picture;
  picture.height = static_cast<int>(rows.size());
  picture.width = static_cast<int>(rows.front().size());
  for (const std::string& row : rows) {
    for (const char c : row) picture.labels.push_back(c == '.' ? 0 : c - '0');
  }
  return picture;
}

std::vector<PixelContour> trace(const Picture& picture, std::int32_t label = 1) {
  return traceContours(picture.labels, picture.width, picture.height, label);
}

using Points = std::vector<Eigen::Vector2i>;

TEST(Contours, SinglePixel) {
  const auto contours = trace(draw({"...", ".1.", "..."}));
  ASSERT_EQ(contours.size(), 1u);
  EXPECT_FALSE(contours[0].is_hole);
  EXPECT_EQ(contours[0].points, Points({{1, 1}}));
  EXPECT_EQ(signedArea(contours[0]), 0.0);
}

TEST(Contours, LineOfPixelsGoesThereAndBack) {
  const auto row = trace(draw({".....", ".111.", "....."}));
  ASSERT_EQ(row.size(), 1u);
  EXPECT_EQ(row[0].points, Points({{1, 1}, {2, 1}, {3, 1}, {2, 1}}));
  const auto column = trace(draw({"1", "1", "1"}));
  ASSERT_EQ(column.size(), 1u);
  EXPECT_EQ(column[0].points, Points({{0, 0}, {0, 1}, {0, 2}, {0, 1}}));
}

TEST(Contours, SquareIsCounterClockwiseOnThePicture) {
  const auto contours = trace(draw({".....", ".111.", ".111.", ".111.", "....."}));
  ASSERT_EQ(contours.size(), 1u);
  EXPECT_EQ(contours[0].points, Points({{1, 1}, {1, 2}, {1, 3}, {2, 3}, {3, 3}, {3, 2}, {3, 1}, {2, 1}}));
  EXPECT_EQ(signedArea(contours[0]), 4.0);
}

TEST(Contours, RingHasAHoleOfTheOtherDirection) {
  const auto contours = trace(draw({"11111", "11.11", "1...1", "11.11", "11111"}));
  ASSERT_EQ(contours.size(), 2u);
  EXPECT_FALSE(contours[0].is_hole);
  EXPECT_EQ(signedArea(contours[0]), 16.0);
  EXPECT_TRUE(contours[1].is_hole);
  EXPECT_EQ(signedArea(contours[1]), -8.0);
  EXPECT_EQ(contours[1].points.size(), 8u);
}

TEST(Contours, HolesTouchingAtACornerAreTwo) {
  const auto contours = trace(draw({"1111", "1.11", "11.1", "1111"}));
  ASSERT_EQ(contours.size(), 3u);
  EXPECT_TRUE(contours[1].is_hole);
  EXPECT_TRUE(contours[2].is_hole);
}

TEST(Contours, IslandInAHoleIsAnOuterContour) {
  const auto contours = trace(draw({"1111111", "1.....1", "1.111.1", "1.1.1.1", "1.111.1", "1.....1", "1111111"}));
  ASSERT_EQ(contours.size(), 4u);
  EXPECT_FALSE(contours[0].is_hole);
  EXPECT_EQ(signedArea(contours[0]), 36.0);
  EXPECT_FALSE(contours[1].is_hole);
  EXPECT_EQ(signedArea(contours[1]), 4.0);
  EXPECT_TRUE(contours[2].is_hole);
  EXPECT_EQ(signedArea(contours[2]), -34.0);  // the four corner pixels are cut
  EXPECT_TRUE(contours[3].is_hole);
  EXPECT_EQ(signedArea(contours[3]), -2.0);
}

TEST(Contours, WholeImageTouchesEveryBorder) {
  const auto contours = trace(draw({"1111", "1111", "1111"}));
  ASSERT_EQ(contours.size(), 1u);
  EXPECT_EQ(contours[0].points.size(), 10u);
  EXPECT_EQ(signedArea(contours[0]), 6.0);
}

TEST(Contours, GapAtTheImageBorderIsNoHole) {
  const auto contours = trace(draw({"11.11", "11.11", "11111"}));
  ASSERT_EQ(contours.size(), 1u);
  EXPECT_FALSE(contours[0].is_hole);
}

TEST(Contours, TwoPiecesLargestFirst) {
  const auto contours = trace(draw({"11....", "11.111", "...111", "...111"}));
  ASSERT_EQ(contours.size(), 2u);
  EXPECT_EQ(signedArea(contours[0]), 4.0);
  EXPECT_EQ(signedArea(contours[1]), 1.0);
  EXPECT_EQ(contours[1].points.front(), Eigen::Vector2i(0, 0));
}

TEST(Contours, EqualPiecesKeepRasterOrder) {
  const auto contours = trace(draw({"...11", "11.11", "11..."}));
  ASSERT_EQ(contours.size(), 2u);
  EXPECT_EQ(contours[0].points.front(), Eigen::Vector2i(3, 0));
  EXPECT_EQ(contours[1].points.front(), Eigen::Vector2i(0, 1));
}

TEST(Contours, DiagonalNeighboursAreOnePiece) {
  const auto contours = trace(draw({"1..", ".1.", "..1"}));
  ASSERT_EQ(contours.size(), 1u);
  EXPECT_EQ(contours[0].points, Points({{0, 0}, {1, 1}, {2, 2}, {1, 1}}));
}

TEST(Contours, OtherLabelsAreBackground) {
  const Picture picture = draw({"1111", "1221", "1111"});
  const auto outer = trace(picture, 1);
  ASSERT_EQ(outer.size(), 2u);
  EXPECT_TRUE(outer[1].is_hole);
  const auto inner = trace(picture, 2);
  ASSERT_EQ(inner.size(), 1u);
  EXPECT_EQ(inner[0].points, Points({{1, 1}, {2, 1}}));
}

TEST(Contours, UnusableInputHasNoContours) {
  const Picture picture = draw({"11", "11"});
  EXPECT_TRUE(traceContours(picture.labels, 2, 3, 1).empty());
  EXPECT_TRUE(traceContours(picture.labels, 0, 2, 1).empty());
  EXPECT_TRUE(traceContours(picture.labels, -2, -2, 1).empty());
  EXPECT_TRUE(traceContours({}, 0, 0, 1).empty());
  EXPECT_TRUE(traceContours(picture.labels, 2, 2, 0).empty());
  EXPECT_TRUE(traceContours(picture.labels, 2, 2, 7).empty());
  EXPECT_TRUE(traceAllContours(picture.labels, 2, 2, -1).empty());
  const auto all = traceAllContours(picture.labels, 2, 3, 2);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(all[0].empty());
}

// --- random label images --------------------------------------------------------------------------

/// Number of connected groups of pixels with `wanted(column, row)` on the image padded by one pixel.
template <typename Wanted>
int countGroups(const Picture& picture, bool eight, Wanted wanted) {
  const int w = picture.width + 2;
  const int h = picture.height + 2;
  std::vector<char> seen(static_cast<std::size_t>(w * h), 0);
  int groups = 0;
  for (int start = 0; start < w * h; ++start) {
    if (seen[static_cast<std::size_t>(start)] || !wanted(start % w - 1, start / w - 1)) continue;
    ++groups;
    std::vector<int> stack{start};
    seen[static_cast<std::size_t>(start)] = 1;
    while (!stack.empty()) {
      const int i = stack.back();
      stack.pop_back();
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (!eight && dx != 0 && dy != 0) continue;
          const int x = i % w + dx;
          const int y = i / w + dy;
          if (x < 0 || x >= w || y < 0 || y >= h || seen[static_cast<std::size_t>(y * w + x)]) continue;
          if (!wanted(x - 1, y - 1)) continue;
          seen[static_cast<std::size_t>(y * w + x)] = 1;
          stack.push_back(y * w + x);
        }
      }
    }
  }
  return groups;
}

/// Turns of the polygon about a pixel that is none of its corners, counter-clockwise on the picture positive.
int windingNumber(const PixelContour& contour, int column, int row) {
  int winding = 0;
  const std::size_t n = contour.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2i& a = contour.points[i];
    const Eigen::Vector2i& b = contour.points[(i + 1) % n];
    // Of the steps that cross the pixel's row to the right of it: down counts -1, up +1.
    const bool down = a.y() <= row && b.y() > row;
    const bool up = b.y() <= row && a.y() > row;
    if (!down && !up) continue;
    const int crossing = down ? a.x() : b.x();  // the end on this row
    if (crossing > column) winding += up ? 1 : -1;
  }
  return winding;
}

void checkAgainstFloodFill(const Picture& picture, std::int32_t label, const std::vector<PixelContour>& contours) {
  const auto inside = [&](int x, int y) { return picture.at(x, y) == label; };
  int outer = 0;
  int holes = 0;
  double previous_area = 0.0;
  std::vector<char> on_border(picture.labels.size(), 0);
  for (const PixelContour& contour : contours) {
    ASSERT_FALSE(contour.points.empty());
    const double area = signedArea(contour);
    if (contour.is_hole) {
      EXPECT_LT(area, 0.0);
    } else {
      EXPECT_EQ(holes, 0) << "an outer border after a hole";
      EXPECT_GE(area, 0.0);
    }
    const bool first_of_kind = (contour.is_hole ? holes++ : outer++) == 0;
    if (!first_of_kind) {
      EXPECT_LE(std::abs(area), previous_area);
    }
    previous_area = std::abs(area);
    const std::size_t n = contour.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Vector2i& p = contour.points[i];
      ASSERT_TRUE(inside(p.x(), p.y()));
      on_border[static_cast<std::size_t>(p.y() * picture.width + p.x())] = 1;
      const Eigen::Vector2i step = contour.points[(i + 1) % n] - p;
      EXPECT_EQ(step.cwiseAbs().maxCoeff(), n == 1 ? 0 : 1);
    }
  }
  EXPECT_EQ(outer, countGroups(picture, true, inside));
  const auto outside = [&](int x, int y) { return picture.at(x, y) != label; };
  EXPECT_EQ(holes, countGroups(picture, false, outside) - 1);

  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const bool border = on_border[static_cast<std::size_t>(y * picture.width + x)] != 0;
      if (inside(x, y) && (outside(x - 1, y) || outside(x + 1, y) || outside(x, y - 1) || outside(x, y + 1))) {
        EXPECT_TRUE(border) << x << ' ' << y;
      }
      if (border) continue;
      int winding = 0;
      for (const PixelContour& contour : contours) winding += windingNumber(contour, x, y);
      EXPECT_EQ(winding, inside(x, y) ? 1 : 0) << x << ' ' << y;
    }
  }
}

TEST(Contours, RandomLabelImagesFillBackToTheLabels) {
  std::mt19937 random(20210626);
  for (int round = 0; round < 300; ++round) {
    Picture picture;
    picture.width = 1 + static_cast<int>(random() % 24);
    picture.height = 1 + static_cast<int>(random() % 18);
    const int labels = 1 + round % 3;
    const unsigned filled = 20 + 15 * static_cast<unsigned>(round % 5);  // per cent
    for (int i = 0; i < picture.width * picture.height; ++i) {
      const bool set = random() % 100 < filled;
      picture.labels.push_back(set ? 1 + static_cast<int>(random() % static_cast<unsigned>(labels)) : 0);
    }
    const auto all = traceAllContours(picture.labels, picture.width, picture.height, labels);
    ASSERT_EQ(all.size(), static_cast<std::size_t>(labels));
    for (int label = 1; label <= labels; ++label) {
      SCOPED_TRACE("round " + std::to_string(round) + ", label " + std::to_string(label));
      const auto& of_label = all[static_cast<std::size_t>(label - 1)];
      checkAgainstFloodFill(picture, label, of_label);
      const auto single = trace(picture, label);
      ASSERT_EQ(single.size(), of_label.size());
      for (std::size_t k = 0; k < single.size(); ++k) {
        EXPECT_EQ(single[k].is_hole, of_label[k].is_hole);
        EXPECT_EQ(single[k].points, of_label[k].points);
      }
      if (HasFailure()) return;
    }
  }
}

}  // namespace
}  // namespace epcc
