// SPDX-License-Identifier: BSD-3-Clause
// Borders along pixel edges: hand-made regions, and random label images against flood fill.
#include "epcc_segmentation/label_arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace epcc {
namespace {

/// A label image, one string a row: '.' is 0, digits are labels.
struct LabelPicture {
  explicit LabelPicture(const std::vector<std::string>& rows)
      : width(static_cast<int>(rows.front().size())), height(static_cast<int>(rows.size())) {
    for (const std::string& row : rows)
      for (const char c : row) labels.push_back(c == '.' ? 0 : c - '0');
  }
  LabelPicture(int columns, int rows, int most, std::mt19937& random) : width(columns), height(rows) {
    for (int i = 0; i < columns * rows; ++i)
      labels.push_back(static_cast<std::int32_t>(random() % static_cast<unsigned>(most + 1)));
  }
  LabelArcs arcs() const { return findLabelArcs(labels, width, height, false); }
  std::int32_t at(int row, int column) const {
    return row < 0 || column < 0 || row >= height || column >= width
               ? 0
               : labels[static_cast<std::size_t>(row * width + column)];
  }

  int width, height;
  std::vector<std::int32_t> labels;
};

/// Pixels to the left of the walk, less those of what it goes round the other way.
long signedPixels(const LabelArcs& arcs, const LabelRing& ring) {
  const std::vector<int> walk = arcs.corners(ring);
  long sum = 0;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const int next = walk[(i + 1) % walk.size()];
    sum += static_cast<long>(arcs.column(next) - arcs.column(walk[i])) * arcs.row(walk[i]);
  }
  return sum;
}

/// Pixels of each connected piece, by flood fill, pieces in the order of their first pixels.
std::vector<long> filledPieces(LabelPicture picture) {
  std::vector<long> sizes;
  for (int first = 0; first < picture.width * picture.height; ++first) {
    const std::int32_t label = picture.labels[static_cast<std::size_t>(first)];
    if (label <= 0) continue;
    long size = 0;
    std::vector<std::pair<int, int>> open = {{first / picture.width, first % picture.width}};
    while (!open.empty()) {
      const auto [row, column] = open.back();
      open.pop_back();
      if (picture.at(row, column) != label) continue;
      picture.labels[static_cast<std::size_t>(row * picture.width + column)] = 0;
      ++size;
      for (const auto& [down, right] : {std::pair(0, 1), {0, -1}, {1, 0}, {-1, 0}})
        open.emplace_back(row + down, column + right);
    }
    sizes.push_back(size);
  }
  return sizes;
}

/// Each step of each arc has the arc's labels to its sides.
void expectLabelsBeside(const LabelPicture& picture, const LabelArcs& arcs) {
  for (const LabelArc& arc : arcs.arcs)
    for (std::size_t i = 0; i + 1 < arc.corners.size(); ++i) {
      const int row = arcs.row(arc.corners[i]), column = arcs.column(arc.corners[i]);
      const int to_row = arcs.row(arc.corners[i + 1]), to_column = arcs.column(arc.corners[i + 1]);
      ASSERT_EQ(std::abs(to_row - row) + std::abs(to_column - column), 1);
      const std::int32_t above = picture.at(row - 1, std::min(column, to_column)),
                         below = picture.at(row, std::min(column, to_column)),
                         before = picture.at(std::min(row, to_row), column - 1),
                         behind = picture.at(std::min(row, to_row), column);
      const bool along_row = row == to_row;
      const bool onwards = along_row ? to_column > column : to_row < row;
      const std::int32_t left = along_row ? above : before, right = along_row ? below : behind;
      EXPECT_EQ(arc.left, onwards ? left : right);
      EXPECT_EQ(arc.right, onwards ? right : left);
    }
}

TEST(LabelArcs, OnePixelIsWalkedAroundFromItsFirstCorner) {
  const LabelArcs arcs = LabelPicture({"...", ".1.", "..."}).arcs();
  ASSERT_EQ(arcs.arcs.size(), 1U);
  ASSERT_EQ(arcs.rings.size(), 1U);
  EXPECT_EQ(arcs.columns, 4);
  EXPECT_EQ(arcs.rings[0].pixels, 1);
  EXPECT_EQ(arcs.rings[0].label, 1);
  EXPECT_EQ(arcs.corners(arcs.rings[0]), (std::vector<int>{5, 9, 10, 6})) << "counter-clockwise on the picture";
}

TEST(LabelArcs, NeighboursShareAnArc) {
  const LabelArcs arcs = LabelPicture({"12", "12"}).arcs();
  EXPECT_EQ(arcs.arcs.size(), 3U) << "round each of them, and between them";
  ASSERT_EQ(arcs.rings.size(), 2U);
  std::map<int, std::set<bool>> directions;
  for (const LabelRing& ring : arcs.rings)
    for (const LabelRing::Part& part : ring.parts) directions[part.arc].insert(part.is_reversed);
  long shared = 0;
  for (const auto& [arc, ways] : directions) {
    const LabelArc& own = arcs.arcs[static_cast<std::size_t>(arc)];
    if (own.left == 0 || own.right == 0) continue;
    ++shared;
    EXPECT_EQ(ways.size(), 2U) << "each walks it its own way";
    EXPECT_EQ(own.corners.size(), 3U);
  }
  EXPECT_EQ(shared, 1);
}

TEST(LabelArcs, PixelsThatTouchAtACornerAreTwoParts) {
  const LabelArcs apart = LabelPicture({"1.", ".1"}).arcs();
  ASSERT_EQ(apart.rings.size(), 2U);
  EXPECT_NE(apart.rings[0].component, apart.rings[1].component);
  // Connected round the other side: what is between them is a hole, though it touches the outside at a corner.
  const LabelArcs joined = LabelPicture({"11.", "1.1", "111"}).arcs();
  ASSERT_EQ(joined.rings.size(), 2U);
  EXPECT_EQ(joined.rings[0].component, joined.rings[1].component);
  EXPECT_EQ(std::max(joined.rings[0].pixels, joined.rings[1].pixels), 8);
  EXPECT_EQ(std::min(joined.rings[0].pixels, joined.rings[1].pixels), 1);
}

TEST(LabelArcs, WhatIsNoImageHasNone) {
  EXPECT_TRUE(findLabelArcs({1, 1}, 2, 2, false).rings.empty());
  EXPECT_TRUE(findLabelArcs({}, 0, 0, false).rings.empty());
  EXPECT_TRUE(findLabelArcs({0, -1, -7, 0}, 2, 2, false).rings.empty());
}

TEST(LabelArcs, OfRandomImagesEncloseThePiecesOfAFloodFill) {
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round) {
    const LabelPicture picture(1 + static_cast<int>(random() % 12), 1 + static_cast<int>(random() % 12),
                               1 + static_cast<int>(random() % 3), random);
    const LabelArcs arcs = picture.arcs();
    std::vector<long> pieces;
    std::vector<int> most, outline;
    for (const LabelRing& ring : arcs.rings) {
      const auto piece = static_cast<std::size_t>(ring.component);
      if (pieces.size() <= piece) {
        pieces.resize(piece + 1, 0);
        most.resize(piece + 1, 0);
        outline.resize(piece + 1, 0);
      }
      const long inside = signedPixels(arcs, ring);
      EXPECT_EQ(std::abs(inside), ring.pixels);
      pieces[piece] += inside;
      most[piece] = std::max(most[piece], ring.pixels);
      if (inside > 0) outline[piece] += ring.pixels;
      const std::vector<int> walk = arcs.corners(ring);
      EXPECT_EQ(std::set<int>(walk.begin(), walk.end()).size(), walk.size()) << "no corner twice";
    }
    EXPECT_EQ(pieces, filledPieces(picture)) << round;
    EXPECT_EQ(outline, most) << "one outline, and the largest of the rings";
    expectLabelsBeside(picture, arcs);
  }
}

}  // namespace
}  // namespace epcc
