// SPDX-License-Identifier: BSD-3-Clause
// Walks along pixel edges with the region to the left, and cuts the walks where more than two labels meet.
#include "epcc_segmentation/label_arcs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <unordered_map>

namespace epcc {

namespace {

constexpr std::size_t kMostPixels = std::numeric_limits<int>::max() / 8;  // their corners can be counted by an int

/// Right, up, left, down on the picture: a turn to the left is the next.
constexpr int kSideColumnStep[4] = {1, 0, -1, 0};
constexpr int kSideRowStep[4] = {0, -1, 0, 1};
/// The pixel to the left of a step from a corner, relative to the corner; to the right it is that of the turn before.
constexpr int kLeftColumn[4] = {0, -1, -1, 0};
constexpr int kLeftRow[4] = {-1, -1, 0, 0};

class ArcFinder {
 public:
  ArcFinder(const std::vector<std::int32_t>& labels, int width, int height, bool closes_round)
      : labels_(labels), width_(width), height_(height), closes_round_(closes_round && width > 2) {
    arcs_.columns = closes_round_ ? width : width + 1;
  }

  LabelArcs find() {
    findComponents();
    const std::size_t corners = static_cast<std::size_t>(arcs_.columns) * static_cast<std::size_t>(height_ + 1);
    passed_.assign(corners, 0);
    place_.assign(corners, -1);
    // Every walk has a step to the right, below the region, or to the left, above it.
    for (int row = 0; row <= height_; ++row)
      for (int column = 0; column < width_; ++column) {
        const int above = row > 0 ? components_[pixel(row - 1, column)] : -1;
        const int below = row < height_ ? components_[pixel(row, column)] : -1;
        if (above == below) continue;
        if (above >= 0) startAt(row * arcs_.columns + column, 0);
        if (below >= 0) startAt(row * arcs_.columns + (column + 1) % arcs_.columns, 2);
      }
    return std::move(arcs_);
  }

 private:
  // ---- pixels ----
  int wrapped(int column) const {
    if (!closes_round_) return column;
    return column < 0 ? column + width_ : column >= width_ ? column - width_ : column;
  }
  bool isInside(int row, int column) const { return row >= 0 && row < height_ && column >= 0 && column < width_; }
  std::size_t pixel(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
  }
  std::int32_t label(int row, int column) const {
    column = wrapped(column);
    return isInside(row, column) ? std::max(0, labels_[pixel(row, column)]) : 0;
  }
  int component(int row, int column) const {
    column = wrapped(column);
    return isInside(row, column) ? components_[pixel(row, column)] : -1;
  }

  int root(int i) {
    while (parent_[static_cast<std::size_t>(i)] != i) {
      int& up = parent_[static_cast<std::size_t>(i)];
      up = parent_[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  }
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  /// Connected parts of the regions, numbered in the order of their first pixels.
  void findComponents() {
    components_.assign(labels_.size(), -1);
    for (int row = 0; row < height_; ++row)
      for (int column = 0; column < width_; ++column) {
        const std::int32_t own = labels_[pixel(row, column)];
        if (own <= 0) continue;
        const bool like_left = column > 0 && labels_[pixel(row, column - 1)] == own;
        const bool like_upper = row > 0 && labels_[pixel(row - 1, column)] == own;
        int& number = components_[pixel(row, column)];
        if (like_left) number = components_[pixel(row, column - 1)];
        if (like_upper) {
          if (like_left)
            join(number, components_[pixel(row - 1, column)]);
          else
            number = components_[pixel(row - 1, column)];
        }
        if (number >= 0) continue;
        number = static_cast<int>(parent_.size());
        parent_.push_back(number);
      }
    if (closes_round_)
      for (int row = 0; row < height_; ++row) {
        const std::size_t first = pixel(row, 0), last = pixel(row, width_ - 1);
        if (labels_[first] > 0 && labels_[first] == labels_[last]) join(components_[first], components_[last]);
      }
    std::vector<int> numbers(parent_.size(), -1);
    int count = 0;
    for (int& number : components_) {
      if (number < 0) continue;
      int& final_number = numbers[static_cast<std::size_t>(root(number))];
      if (final_number < 0) final_number = count++;
      number = final_number;
    }
  }

  // ---- corners ----
  int next(int corner, int direction) const {
    const int row = corner / arcs_.columns + kSideRowStep[direction];
    int column = corner % arcs_.columns + kSideColumnStep[direction];
    if (closes_round_) column = wrapped(column);
    return row * arcs_.columns + column;
  }
  int leftOf(int corner, int direction) const {
    return component(arcs_.row(corner) + kLeftRow[direction], arcs_.column(corner) + kLeftColumn[direction]);
  }
  int rightOf(int corner, int direction) const { return leftOf(corner, (direction + 3) % 4); }
  bool leavesGrid(int corner, int direction) const {
    const int row = arcs_.row(corner) + kSideRowStep[direction];
    const int column = arcs_.column(corner) + kSideColumnStep[direction];
    return row < 0 || row > height_ || (!closes_round_ && (column < 0 || column >= arcs_.columns));
  }
  /// More than two labels meet here, or two in a checkerboard.
  bool isNode(int corner) const {
    const int row = arcs_.row(corner), column = arcs_.column(corner);
    const std::int32_t a = label(row - 1, column - 1), b = label(row - 1, column), c = label(row, column),
                       d = label(row, column - 1);
    const int changes = (a != b) + (b != c) + (c != d) + (d != a);
    return changes > 2;
  }

  // ---- walks ----
  void startAt(int corner, int direction) {
    if ((passed_[static_cast<std::size_t>(corner)] & (1 << direction)) != 0 || leavesGrid(corner, direction)) return;
    const int own = leftOf(corner, direction);
    if (own < 0 || rightOf(corner, direction) == own) return;
    splitWalk(walk(corner, direction, own), own);
  }

  std::vector<int> walk(int start, int direction, int own) {
    std::vector<int> corners;
    int corner = start;
    const int first_direction = direction;
    do {
      corners.push_back(corner);
      passed_[static_cast<std::size_t>(corner)] |= static_cast<std::uint8_t>(1 << direction);
      corner = next(corner, direction);
      // Round its own pixel wherever that is possible, so that pixels that touch at a corner stay apart.
      const int left = (direction + 1) % 4;
      if (leftOf(corner, direction) != own)
        direction = left;
      else if (rightOf(corner, direction) == own)
        direction = (direction + 3) % 4;
    } while (corner != start || direction != first_direction);
    return corners;
  }

  /// A walk that passes a corner twice is two.
  void splitWalk(const std::vector<int>& corners, int own) {
    std::vector<int> open;
    for (const int corner : corners) {
      int& place = place_[static_cast<std::size_t>(corner)];
      if (place >= 0) {
        const auto begin = open.begin() + place;
        const std::vector<int> loop(begin, open.end());
        for (const int passed : loop) place_[static_cast<std::size_t>(passed)] = -1;
        open.erase(begin, open.end());
        addRing(loop, own);
      }
      place = static_cast<int>(open.size());
      open.push_back(corner);
    }
    for (const int passed : open) place_[static_cast<std::size_t>(passed)] = -1;
    addRing(open, own);
  }

  int directionOf(int from, int to) const {
    for (int direction = 0; direction < 4; ++direction)
      if (!leavesGrid(from, direction) && next(from, direction) == to) return direction;
    return 0;
  }

  void addRing(const std::vector<int>& corners, int own) {
    LabelRing ring;
    ring.component = own;
    const int direction = directionOf(corners[0], corners[1]);
    ring.label = label(arcs_.row(corners[0]) + kLeftRow[direction], arcs_.column(corners[0]) + kLeftColumn[direction]);
    ring.pixels = enclosedPixels(corners);
    const std::size_t n = corners.size();
    std::size_t first = 0;
    while (first < n && !isNode(corners[first])) ++first;
    if (first == n) {  // nothing else meets the ring
      first = static_cast<std::size_t>(std::min_element(corners.begin(), corners.end()) - corners.begin());
      addPart(ring, corners, first, n);
    } else {
      for (std::size_t begin = first, end = first; begin < first + n; begin = end) {
        end = begin + 1;
        while (end < first + n && !isNode(corners[end % n])) ++end;
        addPart(ring, corners, begin, end - begin);
      }
    }
    arcs_.rings.push_back(std::move(ring));
  }

  /// By the area of the polygon; 0 of a ring that goes round the scan.
  int enclosedPixels(const std::vector<int>& corners) const {
    long sum = 0;
    int winding = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const int from = corners[i], to = corners[i + 1 < corners.size() ? i + 1 : 0];
      int step = arcs_.column(to) - arcs_.column(from);
      if (step > 1) step = -1;
      if (step < -1) step = 1;
      winding += step;
      sum += static_cast<long>(step) * arcs_.row(from);
    }
    return winding == 0 ? static_cast<int>(std::abs(sum)) : 0;
  }

  /// `steps` steps from the corner at `begin` on.
  void addPart(LabelRing& ring, const std::vector<int>& corners, std::size_t begin, std::size_t steps) {
    std::vector<int> own;
    for (std::size_t i = 0; i <= steps; ++i) own.push_back(corners[(begin + i) % corners.size()]);
    // Both sides walk the arc: it starts at the lower end, or towards the lower of the neighbours of its only end.
    const std::size_t last = own.size() - 1;
    const bool is_reversed = own[0] != own[last] ? own[0] > own[last] : own[1] > own[last - 1];
    if (is_reversed) std::reverse(own.begin(), own.end());
    const std::int64_t key = static_cast<std::int64_t>(own[0]) * 4 + directionOf(own[0], own[1]);
    const auto [known, is_new] = arc_of_step_.emplace(key, static_cast<int>(arcs_.arcs.size()));
    if (is_new) {
      const int direction = directionOf(own[0], own[1]);
      const int row = arcs_.row(own[0]), column = arcs_.column(own[0]), right = (direction + 3) % 4;
      LabelArc arc;
      arc.left = label(row + kLeftRow[direction], column + kLeftColumn[direction]);
      arc.right = label(row + kLeftRow[right], column + kLeftColumn[right]);
      arc.corners = std::move(own);
      arcs_.arcs.push_back(std::move(arc));
    }
    ring.parts.push_back({known->second, is_reversed});
  }

  const std::vector<std::int32_t>& labels_;
  int width_, height_;
  bool closes_round_;
  LabelArcs arcs_;
  std::vector<int> components_, parent_;
  std::vector<std::uint8_t> passed_;  // directions walked from each corner
  std::vector<int> place_;            // of each corner on the walk that is split, -1: none
  std::unordered_map<std::int64_t, int> arc_of_step_;
};

}  // namespace

std::vector<int> LabelArcs::corners(const LabelRing& ring) const {
  std::vector<int> walk;
  for (const LabelRing::Part& part : ring.parts) {
    const std::vector<int>& own = arcs[static_cast<std::size_t>(part.arc)].corners;
    if (part.is_reversed)
      walk.insert(walk.end(), own.rbegin(), own.rend() - 1);
    else
      walk.insert(walk.end(), own.begin(), own.end() - 1);
  }
  return walk;
}

LabelArcs findLabelArcs(const std::vector<std::int32_t>& labels, int width, int height, bool closes_round) {
  if (width <= 0 || height <= 0 || labels.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    return LabelArcs();
  if (labels.size() > kMostPixels) return LabelArcs();
  return ArcFinder(labels, width, height, closes_round).find();
}

}  // namespace epcc
