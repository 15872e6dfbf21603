// SPDX-License-Identifier: BSD-3-Clause
// Cells become a picture, its pieces are walked around, and the walks drawn simpler.
#include "eval/track/grid_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "datasets/files/image.h"
#include "eval/track/ring_drawing.h"

namespace epcc {
namespace {

using Mask = Image<std::uint8_t>;

constexpr int kMargin = 3;
constexpr int kOutside = 1;  // number of the empty piece in the first corner
constexpr long kMaxCells = 64L * 1000 * 1000;
constexpr double kTolerance = 1.0;  // cells
constexpr std::array<int, 4> kStepX = {1, 0, -1, 0}, kStepY = {0, 1, 0, -1};

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

/// Numbers the connected pieces of cells with this value from 1, with their sizes; [0] is not used.
std::vector<int> numberPieces(const Mask& mask, std::uint8_t value, Image<int>& numbers) {
  numbers = Image<int>(mask.width, mask.height);
  std::vector<int> sizes(1, 0);
  std::vector<std::pair<int, int>> open;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      if (mask.at(y, x) != value || numbers.at(y, x) != 0) continue;
      const int number = static_cast<int>(sizes.size());
      sizes.push_back(0);
      numbers.at(y, x) = number;
      open.assign(1, {x, y});
      while (!open.empty()) {
        const auto [cx, cy] = open.back();
        open.pop_back();
        ++sizes.back();
        for (std::size_t d = 0; d < 4; ++d) {
          const int nx = cx + kStepX[d], ny = cy + kStepY[d];
          if (nx < 0 || ny < 0 || nx >= mask.width || ny >= mask.height) continue;
          if (mask.at(ny, nx) != value || numbers.at(ny, nx) != 0) continue;
          numbers.at(ny, nx) = number;
          open.emplace_back(nx, ny);
        }
      }
    }
  return sizes;
}

/// Small holes are filled and small pieces dropped.
void dropSmall(Mask& mask, int min_cells) {
  Image<int> numbers;
  const std::vector<int> holes = numberPieces(mask, 0, numbers);
  for (std::size_t i = 0; i < mask.data.size(); ++i)
    if (numbers.data[i] > kOutside && holes[static_cast<std::size_t>(numbers.data[i])] < min_cells) mask.data[i] = 1;
  const std::vector<int> pieces = numberPieces(mask, 1, numbers);
  const auto largest = std::max_element(pieces.begin(), pieces.end()) - pieces.begin();
  for (std::size_t i = 0; i < mask.data.size(); ++i) {
    const int number = numbers.data[i];
    if (number > 0 && number != largest && pieces[static_cast<std::size_t>(number)] < min_cells) mask.data[i] = 0;
  }
}

/// The sides of cells on the border, by the corner where they start: a bit for each direction, the cell on their left.
Mask borderSides(const Mask& mask) {
  Mask sides(mask.width + 1, mask.height + 1);
  for (int y = 1; y + 1 < mask.height; ++y)
    for (int x = 1; x + 1 < mask.width; ++x) {
      if (mask.at(y, x) == 0) continue;
      const auto add = [&](int at_x, int at_y, int direction) {
        sides.at(at_y, at_x) = static_cast<std::uint8_t>(sides.at(at_y, at_x) | (1 << direction));
      };
      if (mask.at(y - 1, x) == 0) add(x, y, 0);
      if (mask.at(y, x + 1) == 0) add(x + 1, y, 1);
      if (mask.at(y + 1, x) == 0) add(x + 1, y + 1, 2);
      if (mask.at(y, x - 1) == 0) add(x, y + 1, 3);
    }
  return sides;
}

/// Walks along the border from a side on, and takes away the sides it has walked: corners where it turns. At a corner
/// that two cells share it stays with its own cell.
Ring walk(Mask& sides, const int first_x, const int first_y, const int first_direction) {
  const auto take = [&](int x, int y, int direction) {
    sides.at(y, x) = static_cast<std::uint8_t>(sides.at(y, x) & ~(1 << direction));
  };
  Ring ring;
  int x = first_x, y = first_y, direction = first_direction, last = -1;
  do {
    if (direction != last) ring.emplace_back(x, y);
    if (last >= 0) take(x, y, direction);  // the first side stays to be met again
    last = direction;
    x += kStepX[static_cast<std::size_t>(direction)];
    y += kStepY[static_cast<std::size_t>(direction)];
    for (const int turn : {1, 0, 3}) {
      direction = (last + turn) % 4;
      if ((sides.at(y, x) >> direction & 1) != 0) break;
    }
  } while (x != first_x || y != first_y || direction != first_direction);
  take(first_x, first_y, first_direction);
  return ring;
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
  const long width = static_cast<long>(right) - left + 1 + 2 * kMargin;
  const long height = static_cast<long>(high) - low + 1 + 2 * kMargin;
  if (width * height > kMaxCells) return {};
  Mask mask(static_cast<int>(width), static_cast<int>(height));
  for (const auto& [x, y] : cells) mask.at(y - low + kMargin, x - left + kMargin) = 1;
  mask = ofNeighbours(ofNeighbours(mask, false), true);
  dropSmall(mask, min_cells);

  Image<int> numbers;
  numberPieces(mask, 1, numbers);
  Mask sides = borderSides(mask);
  std::map<int, std::vector<Ring>> rings;  // of each piece, its outline first
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x)
      while (sides.at(y, x) != 0) {
        int direction = 0;
        while ((sides.at(y, x) >> direction & 1) == 0) ++direction;
        // The cell on the left of the first side.
        constexpr std::array<int, 4> kCellX = {0, -1, -1, 0}, kCellY = {0, 0, -1, -1};
        const auto d = static_cast<std::size_t>(direction);
        std::vector<Ring>& of_piece = rings[numbers.at(y + kCellY[d], x + kCellX[d])];
        of_piece.push_back(walk(sides, x, y, direction));
        if (areaOf(of_piece.back()) > 0.0) std::swap(of_piece.front(), of_piece.back());
      }

  std::vector<CellPiece> pieces;
  const Eigen::Vector2d shift(left - kMargin, low - kMargin);
  for (auto& [number, of_piece] : rings) {
    std::vector<Ring> drawn = drawnSimpler(of_piece, kTolerance);
    for (Ring& ring : drawn)
      for (Eigen::Vector2d& corner : ring) corner += shift;
    CellPiece piece;
    piece.outline = std::move(drawn.front());
    for (std::size_t i = 1; i < drawn.size(); ++i) piece.holes.push_back(std::move(drawn[i]));
    pieces.push_back(std::move(piece));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const CellPiece& a, const CellPiece& b) { return areaOf(a.outline) > areaOf(b.outline); });
  return pieces;
}

}  // namespace epcc
