// SPDX-License-Identifier: BSD-3-Clause
// Cells become a picture, its pieces are walked around, and the walks drawn simpler.
#include "eval/track/grid_outline.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "datasets/files/image.h"
#include "epcc_segmentation/label_arcs.h"
#include "eval/track/ring_drawing.h"

namespace epcc {
namespace {

using Mask = Image<std::uint8_t>;

constexpr int kOutlineMargin = 3;
constexpr long kMaxCells = 64L * 1000 * 1000;
constexpr double kTolerance = 1.0;  // cells

/// A cell is set if any (`all` false) or all of the nine around it are set.
Mask ofNeighbours(const Mask& mask, bool all) {
  Mask result(mask.width, mask.height);
  for (int y = 1; y + 1 < mask.height; ++y)
    for (int x = 1; x + 1 < mask.width; ++x) {
      int set = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) set += mask.at(y + dy, x + dx);
      result.at(y, x) = all ? (set == 9 ? 1 : 0) : (set > 0 ? 1 : 0);
    }
  return result;
}

/// The rings of each connected piece, its outline first. Small holes and small pieces are left out.
std::vector<std::vector<const LabelRing*>> piecesOf(const LabelArcs& arcs, int min_cells) {
  std::vector<std::vector<const LabelRing*>> pieces;
  for (const LabelRing& ring : arcs.rings) {
    const auto piece = static_cast<std::size_t>(ring.component);
    if (pieces.size() <= piece) pieces.resize(piece + 1);
    pieces[piece].push_back(&ring);
  }
  std::vector<long> cells;
  for (std::vector<const LabelRing*>& rings : pieces) {
    std::stable_sort(rings.begin(), rings.end(),
                     [](const LabelRing* a, const LabelRing* b) { return a->pixels > b->pixels; });
    while (rings.size() > 1 && rings.back()->pixels < min_cells) rings.pop_back();
    cells.push_back(rings.front()->pixels);
    for (std::size_t i = 1; i < rings.size(); ++i) cells.back() -= rings[i]->pixels;
  }
  const auto largest = std::max_element(cells.begin(), cells.end()) - cells.begin();
  std::vector<std::vector<const LabelRing*>> kept;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (static_cast<long>(i) == largest || cells[i] >= min_cells) kept.push_back(std::move(pieces[i]));
  return kept;
}

/// Corners where the walk turns, those of cells that were counted from `origin` on. Rows run upwards here: the walk is
/// the other way round.
Ring cornersOf(const LabelArcs& arcs, const LabelRing& ring, const Eigen::Vector2d& origin) {
  std::vector<int> walk = arcs.corners(ring);
  std::reverse(walk.begin() + 1, walk.end());
  Ring corners;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const int before = walk[i > 0 ? i - 1 : walk.size() - 1], after = walk[i + 1 < walk.size() ? i + 1 : 0];
    if (arcs.row(before) == arcs.row(after) || arcs.column(before) == arcs.column(after)) continue;
    corners.push_back(origin + Eigen::Vector2d(arcs.column(walk[i]), arcs.row(walk[i])));
  }
  return corners;
}

double areaOf(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

}  // namespace

std::vector<CellPiece> cellPieces(const std::vector<std::pair<int, int>>& cells, int min_cells) {
  if (cells.empty()) return {};
  int left = cells[0].first, right = left, low = cells[0].second, high = low;
  for (const auto& [x, y] : cells) {
    left = std::min(left, x);
    right = std::max(right, x);
    low = std::min(low, y);
    high = std::max(high, y);
  }
  const long width = static_cast<long>(right) - left + 1 + 2 * kOutlineMargin;
  const long height = static_cast<long>(high) - low + 1 + 2 * kOutlineMargin;
  if (width * height > kMaxCells) return {};
  Mask mask(static_cast<int>(width), static_cast<int>(height));
  for (const auto& [x, y] : cells) mask.at(y - low + kOutlineMargin, x - left + kOutlineMargin) = 1;
  mask = ofNeighbours(ofNeighbours(mask, false), true);

  const std::vector<std::int32_t> labels(mask.data.begin(), mask.data.end());
  const LabelArcs arcs = findLabelArcs(labels, mask.width, mask.height, false);
  const Eigen::Vector2d origin(left - kOutlineMargin, low - kOutlineMargin);
  std::vector<CellPiece> pieces;
  for (const std::vector<const LabelRing*>& of_piece : piecesOf(arcs, min_cells)) {
    std::vector<Ring> rings;
    for (const LabelRing* ring : of_piece) rings.push_back(cornersOf(arcs, *ring, origin));
    std::vector<Ring> drawn = drawnSimpler(rings, kTolerance);
    CellPiece piece;
    piece.outline = std::move(drawn.front());
    piece.holes.assign(std::make_move_iterator(drawn.begin() + 1), std::make_move_iterator(drawn.end()));
    pieces.push_back(std::move(piece));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const CellPiece& a, const CellPiece& b) { return areaOf(a.outline) > areaOf(b.outline); });
  return pieces;
}

}  // namespace epcc
