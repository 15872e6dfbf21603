// SPDX-License-Identifier: BSD-3-Clause
// Each side is moved along its normal; corners go where moved sides meet.
#include "geometry/balanced_lines.h"

#include <cmath>

#include "geometry/flat_cross.h"

namespace epcc {

namespace {

constexpr double kStraight = 0.3;      // sine of the angle below which two sides have no place where they meet
constexpr double kLargestShift = 0.9;  // pixels
constexpr int kBalancingPasses = 3;
constexpr double kStays = 1e-6;  // pixels: a side along the pixels' edges is where it is

/// A side of the drawn line and how far it moves along its normal.
struct Side {
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();
  double move = 0.0;
};

Side balancedSide(const std::vector<Eigen::Vector2d>& places, std::size_t from, std::size_t to) {
  Side side;
  const Eigen::Vector2d chord = places[to] - places[from];
  const double length = chord.norm();
  if (!(length > 0.0)) return side;
  side.normal = Eigen::Vector2d(-chord.y(), chord.x()) / length;
  double twice = 0.0;  // area between the corners and the chord
  for (std::size_t i = from; i < to; ++i) twice += cross(places[i] - places[from], places[i + 1] - places[from]);
  side.move = -0.5 * twice / length;
  return side;
}

/// Where the corner between two sides goes.
Eigen::Vector2d corner(const Side& before, const Side& after) {
  const double turn = cross(before.normal, after.normal);
  Eigen::Vector2d shift;
  if (std::abs(turn) < kStraight) {
    shift = 0.5 * (before.move * before.normal + after.move * after.normal);
  } else {
    shift.x() = (before.move * after.normal.y() - after.move * before.normal.y()) / turn;
    shift.y() = (after.move * before.normal.x() - before.move * after.normal.x()) / turn;
  }
  const double distance = shift.norm();
  if (distance > kLargestShift) shift *= kLargestShift / distance;
  return shift;
}

std::vector<Eigen::Vector2d> shiftsOf(const std::vector<Side>& sides, bool is_whole) {
  std::vector<Eigen::Vector2d> shifts(sides.size() + 1, Eigen::Vector2d::Zero());
  for (std::size_t i = 1; i < sides.size(); ++i) shifts[i] = corner(sides[i - 1], sides[i]);
  if (is_whole && sides.size() > 2) shifts.front() = shifts.back() = corner(sides.back(), sides.front());
  return shifts;
}

}  // namespace

std::vector<Eigen::Vector2d> balancedShifts(const std::vector<Eigen::Vector2d>& places,
                                            const std::vector<std::size_t>& kept, std::size_t begin, bool is_whole) {
  std::vector<Side> sides;
  double length = 0.0, twice_of_corners = 0.0;
  for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
    const std::size_t from = kept[i] - begin, to = kept[i + 1] - begin;
    sides.push_back(balancedSide(places, from, to));
    if (std::abs(sides.back().move) > kStays) length += (places[to] - places[from]).norm();
  }
  for (std::size_t i = 0; i + 1 < places.size(); ++i) twice_of_corners += cross(places[i], places[i + 1]);
  if (!is_whole && sides.size() > 1) {  // a side that one end holds turns about it: its other end moves twice as far
    sides.front().move *= 2.0;
    sides.back().move *= 2.0;
  }
  // What moved sides cut off or add where they meet is shared out among all of them.
  for (int pass = 0;; ++pass) {
    const std::vector<Eigen::Vector2d> shifts = shiftsOf(sides, is_whole);
    if (pass == kBalancingPasses || sides.size() < 2 || !(length > 0.0)) return shifts;
    double twice = 0.0;
    for (std::size_t i = 0; i + 1 < kept.size(); ++i)
      twice += cross(places[kept[i] - begin] + shifts[i], places[kept[i + 1] - begin] + shifts[i + 1]);
    const double rest = 0.5 * (twice - twice_of_corners);
    if (std::abs(rest) < 1e-9 * length) return shifts;
    for (Side& side : sides)
      if (std::abs(side.move) > kStays) side.move += rest / length;
  }
}

}  // namespace epcc
