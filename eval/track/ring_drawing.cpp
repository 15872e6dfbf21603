// SPDX-License-Identifier: BSD-3-Clause
// Points are left out by Douglas and Peucker; where lines would cross, fewer of them.
#include "eval/track/ring_drawing.h"

#include <algorithm>
#include <utility>

namespace epcc {
namespace {

constexpr double kLeastShare = 0.2;  // of the tolerance: below, rings stay as they are

double distanceFromSide(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d side = b - a;
  const double length = side.squaredNorm();
  const double share = length > 0.0 ? std::clamp((p - a).dot(side) / length, 0.0, 1.0) : 0.0;
  return (p - a - share * side).norm();
}

/// Douglas and Peucker, between two points that stay.
void keepBetween(const Ring& ring, std::size_t from, std::size_t to, double tolerance, std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{from, to}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    double most = tolerance;
    std::size_t farthest = a;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double distance = distanceFromSide(ring[i], ring[a], ring[b % ring.size()]);
      if (distance > most) {
        most = distance;
        farthest = i;
      }
    }
    if (farthest == a) continue;
    kept[farthest] = true;
    open.emplace_back(a, farthest);
    open.emplace_back(farthest, b);
  }
}

Ring simpler(const Ring& ring, double tolerance) {
  std::size_t far = 0;
  for (std::size_t i = 1; i < ring.size(); ++i)
    if ((ring[i] - ring[0]).squaredNorm() > (ring[far] - ring[0]).squaredNorm()) far = i;
  std::vector<bool> kept(ring.size(), false);
  kept[0] = kept[far] = true;
  keepBetween(ring, 0, far, tolerance, kept);
  keepBetween(ring, far, ring.size(), tolerance, kept);
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (kept[i]) result.push_back(ring[i]);
  return result;
}

struct Side {
  Eigen::Vector2d a, b;
};

/// Whether two sides have a point in common that is not an end of both.
bool touch(const Side& s, const Side& t) {
  const auto turn = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const double cross = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    return cross > 1e-12 ? 1 : cross < -1e-12 ? -1 : 0;
  };
  if (std::max(s.a.x(), s.b.x()) < std::min(t.a.x(), t.b.x()) ||
      std::max(t.a.x(), t.b.x()) < std::min(s.a.x(), s.b.x()) ||
      std::max(s.a.y(), s.b.y()) < std::min(t.a.y(), t.b.y()) ||
      std::max(t.a.y(), t.b.y()) < std::min(s.a.y(), s.b.y()))
    return false;
  const int t1 = turn(s.a, s.b, t.a), t2 = turn(s.a, s.b, t.b), t3 = turn(t.a, t.b, s.a), t4 = turn(t.a, t.b, s.b);
  if (s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) {  // more than the end only on one line, on the same side
    if (t1 != 0 || t2 != 0) return false;
    const Eigen::Vector2d common = s.a == t.a || s.a == t.b ? s.a : s.b;
    const Eigen::Vector2d s_other = s.a == common ? s.b : s.a, t_other = t.a == common ? t.b : t.a;
    return (s_other - common).dot(t_other - common) > 0.0;
  }
  return t1 * t2 <= 0 && t3 * t4 <= 0;
}

bool isSimple(const std::vector<Ring>& rings) {
  std::vector<Side> sides;
  for (const Ring& ring : rings) {
    if (ring.size() < 3) return false;
    for (std::size_t i = 0; i < ring.size(); ++i) sides.push_back({ring[i], ring[(i + 1) % ring.size()]});
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& s, const Side& t) { return std::min(s.a.x(), s.b.x()) < std::min(t.a.x(), t.b.x()); });
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      if (std::min(sides[j].a.x(), sides[j].b.x()) > std::max(sides[i].a.x(), sides[i].b.x())) break;
      if (touch(sides[i], sides[j])) return false;
    }
  return true;
}

}  // namespace

std::vector<Ring> drawnSimpler(const std::vector<Ring>& rings, double most) {
  for (double tolerance = most; tolerance > kLeastShare * most; tolerance *= 0.5) {
    std::vector<Ring> drawn;
    for (const Ring& ring : rings) drawn.push_back(simpler(ring, tolerance));
    if (isSimple(drawn)) return drawn;
  }
  return rings;
}

}  // namespace epcc
