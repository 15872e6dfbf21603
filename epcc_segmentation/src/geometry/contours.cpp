// SPDX-License-Identifier: BSD-3-Clause
// Border following after Suzuki and Abe (1985), for all labels of an image in one pass.
#include "epcc_segmentation/contours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace epcc {
namespace {

/// The eight neighbours, clockwise on the picture, from the right-hand one.
constexpr int kColumnStep[8] = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr int kRowStep[8] = {0, 1, 1, 1, 0, -1, -1, -1};
constexpr int kRight = 0;
constexpr int kLeft = 4;

class BorderFollower {
 public:
  BorderFollower(const std::vector<std::int32_t>& labels, int width, int height)
      : labels_(labels), width_(width), height_(height), marks_(labels.size(), kNew) {}

  /// Calls found(label, contour) for each border of the labels first..last, outer borders before their holes.
  template <typename Found>
  void trace(std::int32_t first, std::int32_t last, Found found) {
    for (int row = 0; row < height_; ++row) {
      for (int column = 0; column < width_; ++column) {
        const std::size_t i = index(column, row);
        const std::int32_t label = labels_[i];
        if (label < first || label > last) continue;
        // The first pixel of a piece; or a right-hand side no border has passed, which is a hole's first pixel.
        if (marks_[i] == kNew && !isRegion(column - 1, row, label)) {
          found(label, follow(column, row, kLeft, label));
        }
        if (marks_[i] != kRightSeen && !isRegion(column + 1, row, label)) {
          found(label, follow(column, row, kRight, label));
        }
      }
    }
  }

 private:
  enum Mark : std::uint8_t { kNew, kSeen, kRightSeen };

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
  }
  bool isRegion(int column, int row, std::int32_t label) const {
    return column >= 0 && column < width_ && row >= 0 && row < height_ && labels_[index(column, row)] == label;
  }
  bool isRegion(const Eigen::Vector2i& pixel, int direction, std::int32_t label) const {
    return isRegion(pixel.x() + kColumnStep[direction], pixel.y() + kRowStep[direction], label);
  }

  /// Walks the border that separates the start pixel from its neighbour in direction `background`.
  PixelContour follow(int column, int row, int background, std::int32_t label) {
    PixelContour contour;
    contour.is_hole = background == kRight;
    const Eigen::Vector2i start(column, row);

    int turn = 1;
    while (turn < 8 && !isRegion(start, (background + turn) % 8, label)) ++turn;
    if (turn == 8) {
      contour.points.push_back(start);
      marks_[index(column, row)] = kRightSeen;
      return contour;
    }
    int from = (background + turn) % 8;  // direction from the current pixel to the one before it on the border
    const Eigen::Vector2i last(column + kColumnStep[from], row + kRowStep[from]);

    Eigen::Vector2i pixel = start;
    while (true) {
      contour.points.push_back(pixel);
      int next = from;
      bool right_seen = false;
      do {
        next = (next + 7) % 8;
        if (isRegion(pixel, next, label)) break;
        right_seen |= next == kRight;
      } while (next != from);

      Mark& mark = marks_[index(pixel.x(), pixel.y())];
      if (right_seen) {
        mark = kRightSeen;
      } else if (mark == kNew) {
        mark = kSeen;
      }

      const Eigen::Vector2i before = pixel;
      pixel += Eigen::Vector2i(kColumnStep[next], kRowStep[next]);
      if (pixel == start && before == last) return contour;
      from = (next + 4) % 8;
    }
  }

  const std::vector<std::int32_t>& labels_;
  int width_;
  int height_;
  std::vector<Mark> marks_;
};

bool isUsable(const std::vector<std::int32_t>& labels, int width, int height) {
  return width > 0 && height > 0 && labels.size() >= static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// Outer borders first, the largest area first; borders found earlier stay first among equals.
void sortContours(std::vector<PixelContour>& contours) {
  struct Key {
    bool is_hole;
    double area;
    std::size_t index;
  };
  std::vector<Key> keys;
  keys.reserve(contours.size());
  for (std::size_t i = 0; i < contours.size(); ++i) {
    keys.push_back({contours[i].is_hole, std::fabs(signedArea(contours[i])), i});
  }
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    if (a.is_hole != b.is_hole) return b.is_hole;
    if (a.area != b.area) return a.area > b.area;
    return a.index < b.index;
  });
  std::vector<PixelContour> sorted;
  sorted.reserve(contours.size());
  for (const Key& key : keys) sorted.push_back(std::move(contours[key.index]));
  contours.swap(sorted);
}

}  // namespace

std::vector<PixelContour> traceContours(const std::vector<std::int32_t>& labels, int width, int height,
                                        std::int32_t label) {
  std::vector<PixelContour> contours;
  if (label <= 0 || !isUsable(labels, width, height)) return contours;
  BorderFollower(labels, width, height).trace(label, label, [&](std::int32_t, PixelContour&& contour) {
    contours.push_back(std::move(contour));
  });
  sortContours(contours);
  return contours;
}

std::vector<std::vector<PixelContour>> traceAllContours(const std::vector<std::int32_t>& labels, int width, int height,
                                                        int label_count) {
  std::vector<std::vector<PixelContour>> contours(static_cast<std::size_t>(std::max(0, label_count)));
  if (contours.empty() || !isUsable(labels, width, height)) return contours;
  BorderFollower(labels, width, height).trace(1, label_count, [&](std::int32_t label, PixelContour&& contour) {
    contours[static_cast<std::size_t>(label - 1)].push_back(std::move(contour));
  });
  for (std::vector<PixelContour>& of_label : contours) sortContours(of_label);
  return contours;
}

double signedArea(const PixelContour& contour) {
  std::int64_t twice_area = 0;
  const std::size_t n = contour.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2i& a = contour.points[i];
    const Eigen::Vector2i& b = contour.points[i + 1 < n ? i + 1 : 0];
    // Rows grow downwards: the sign of the usual formula changes.
    twice_area += static_cast<std::int64_t>(b.x()) * a.y() - static_cast<std::int64_t>(a.x()) * b.y();
  }
  return 0.5 * static_cast<double>(twice_area);
}

}  // namespace epcc
