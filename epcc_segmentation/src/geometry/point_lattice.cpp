// SPDX-License-Identifier: BSD-3-Clause
// Reads the lattice and finds the points that a driver writes where it has none.
#include "geometry/point_lattice.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace epcc {

namespace {

// So often in the lattice, and at least in this share of it, a point is no coincidence of rounded coordinates.
constexpr std::size_t kMinRepeats = 3;
constexpr double kMinRepeatedShare = 0.002;

void spread(int count, int most, std::vector<int>& places) {
  const int n = std::min(count, most);
  places.resize(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) places[static_cast<std::size_t>(i)] = static_cast<int>((2L * i + 1) * count / (2L * n));
}

bool lessThan(const Vector3f& a, const Vector3f& b) {
  return std::make_tuple(a.x(), a.y(), a.z()) < std::make_tuple(b.x(), b.y(), b.z());
}

}  // namespace

bool PointLattice::isWhole(const CloudView& cloud) const {
  return rows_.size() == static_cast<std::size_t>(cloud.height) &&
         columns_.size() == static_cast<std::size_t>(cloud.width);
}

void PointLattice::read(const CloudView& cloud, int max_rows, int max_columns, const std::optional<float>& invalid,
                        std::vector<Vector3f>& markers) {
  spread(cloud.height, max_rows, rows_);
  spread(cloud.width, max_columns, columns_);
  points_.clear();
  for (std::size_t r = 0; r < rows_.size(); ++r)
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const std::size_t pixel = static_cast<std::size_t>(rows_[r]) * static_cast<std::size_t>(cloud.width) +
                                static_cast<std::size_t>(columns_[c]);
      const float* p = cloud.xyz + pixel * cloud.stride;
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) continue;
      if (p[0] == 0.0f && p[1] == 0.0f && p[2] == 0.0f) continue;
      if (invalid && p[0] == *invalid && p[1] == *invalid && p[2] == *invalid) continue;
      points_.push_back({static_cast<int>(r), static_cast<int>(c), Vector3f(p[0], p[1], p[2]).cast<double>()});
    }
  dropRepeated(markers);
}

void PointLattice::dropRepeated(std::vector<Vector3f>& markers) {
  sorted_.clear();
  for (const Point& point : points_) sorted_.push_back(point.p.cast<float>());
  std::sort(sorted_.begin(), sorted_.end(), lessThan);
  const auto enough =
      std::max(kMinRepeats, static_cast<std::size_t>(kMinRepeatedShare * static_cast<double>(sorted_.size())));
  markers.clear();
  for (std::size_t begin = 0, end = 0; begin < sorted_.size(); begin = end) {
    while (end < sorted_.size() && sorted_[end] == sorted_[begin]) ++end;
    if (end - begin >= enough) markers.push_back(sorted_[begin]);
  }
  if (markers.empty()) return;
  const auto is_marker = [&](const Point& point) {
    return std::binary_search(markers.begin(), markers.end(), Vector3f(point.p.cast<float>()), lessThan);
  };
  points_.erase(std::remove_if(points_.begin(), points_.end(), is_marker), points_.end());
}

}  // namespace epcc
