// SPDX-License-Identifier: BSD-3-Clause
// The projection of an organized cloud, from the angles between neighbouring points of its columns.
#include <cmath>

#include "epcc_segmentation/depth_frame.h"

namespace epcc {

namespace {

constexpr int kMaxColumns = 64;
constexpr int kMaxPairs = 64;  // in a column
constexpr long kMinPairs = 16;

struct Sample {
  double x, y, z;
};

/// Grows with the angle between two directions, and is the angle where that is small: no trigonometry for thousands
/// of pairs.
double angle(double ax, double ay, double bx, double by) {
  const double lengths = std::sqrt((ax * ax + ay * ay) * (bx * bx + by * by));
  if (!(lengths > 0.0)) return 0.0;
  const double sine = std::abs(ax * by - ay * bx) / lengths;
  return ax * bx + ay * by >= 0.0 ? sine : 2.0 - sine;
}

/// Sums over pairs of neighbouring points of a column.
class ColumnAngles {
 public:
  ColumnAngles(const float* xyz, std::size_t stride, int width, int height)
      : xyz_(xyz), stride_(stride), width_(width), height_(height) {}

  void addColumn(int column) {
    const int step = height_ > kMaxPairs ? height_ / kMaxPairs : 1;
    Sample first, second;
    int row = nextValid(0, column, first);
    while (row < height_) {
      const int other = nextValid(row + 1, column, second);
      if (other == height_) return;
      addPair(first, second);
      // Close pairs far apart; in a small column each point is the end of one pair and the start of the next.
      row = step == 1 ? other : nextValid(row + step > other ? row + step : other, column, first);
      if (step == 1) first = second;
    }
  }

  Projection projection() const {
    // A camera sees one side of z = 0 only; ten times clearer is clear enough.
    const Projection perspective = 2 * behind_ > points_ ? Projection::PerspectiveBackward : Projection::Perspective;
    if (pairs_ < kMinPairs) return Projection::Perspective;
    if ((behind_ == 0 || behind_ == points_) && spherical_ > 0.1 * perspective_) return perspective;
    return spherical_ < perspective_ ? Projection::Spherical : perspective;
  }

 private:
  /// The first valid point from `row` on; the height if there is none.
  int nextValid(int row, int column, Sample& sample) const {
    for (; row < height_; ++row) {
      const float* p = xyz_ + (static_cast<std::size_t>(row) * width_ + column) * stride_;
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) continue;
      if (p[0] == 0.0f && p[1] == 0.0f && p[2] == 0.0f) continue;
      sample = {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
      return row;
    }
    return height_;
  }

  void addPair(const Sample& a, const Sample& b) {
    perspective_ += angle(a.x, a.z, b.x, b.z);  // x/z is constant along the column of a perspective cloud
    spherical_ += angle(a.x, a.y, b.x, b.y);    // the azimuth along that of a spherical one
    ++pairs_;
    points_ += 2;
    behind_ += (a.z <= 0.0) + (b.z <= 0.0);
  }

  const float* xyz_;
  std::size_t stride_;
  int width_, height_;
  double perspective_ = 0.0, spherical_ = 0.0;
  long pairs_ = 0, points_ = 0, behind_ = 0;
};

}  // namespace

Projection detectProjection(const float* xyz, std::size_t stride, int width, int height) {
  ColumnAngles angles(xyz, stride, width, height);
  const int step = width > kMaxColumns ? width / kMaxColumns : 1;
  for (int column = 0; column < width; column += step) angles.addColumn(column);
  return angles.projection();
}

}  // namespace epcc
