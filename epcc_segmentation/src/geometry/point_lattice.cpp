// SPDX-License-Identifier: BSD-3-Clause
// Reads the lattice and finds the points that a driver writes where it has none.
#include "geometry/point_lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace epcc {

namespace {

// So often in the lattice, and at least in this share of it, a point is no coincidence of rounded coordinates.
constexpr std::size_t kMinRepeats = 3;
constexpr double kMinRepeatedShare = 0.002;
constexpr std::size_t kMaxMarkers = 4;
constexpr double kGoldenRatio = 0.6180339887498949;  // its multiples fill the range evenly
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// One place in each of `most` equal parts, at another height of each: where a header is wrong, rows that are halves or
/// thirds of others would look right in every second or third.
void spread(int count, int most, std::vector<int>& places) {
  const int n = std::min(count, most);
  places.resize(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const long first = static_cast<long>(i) * count / n, next = (i + 1L) * count / n;
    const double height = std::fmod((i + 1) * kGoldenRatio, 1.0);
    places[static_cast<std::size_t>(i)] =
        static_cast<int>(first + static_cast<long>(height * static_cast<double>(next - first)));
  }
}

std::size_t hashOf(const Eigen::Vector3d& p) {
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k) {
    std::uint64_t bits;
    std::memcpy(&bits, &p(k), sizeof bits);
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15;
    hash ^= hash >> 29;
  }
  return hash;
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

// A table with open addressing: places of points that are the first of their kind.
void PointLattice::dropRepeated(std::vector<Vector3f>& markers) {
  markers.clear();
  std::size_t size = 256;
  while (size < 4 * points_.size()) size *= 2;
  first_.assign(size, kNone);
  repeats_.assign(points_.size(), 0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    std::size_t place = hashOf(points_[i].p) & (size - 1);
    while (first_[place] != kNone && points_[first_[place]].p != points_[i].p) place = (place + 1) & (size - 1);
    if (first_[place] == kNone) first_[place] = i;
    ++repeats_[first_[place]];
  }
  const auto share = static_cast<std::size_t>(kMinRepeatedShare * static_cast<double>(points_.size()));
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (repeats_[i] >= std::max(kMinRepeats, share)) markers.push_back(points_[i].p.cast<float>());
  // Many points that stand in several places are coarse numbers, not marks of nothing.
  if (markers.size() > kMaxMarkers) markers.clear();
  if (markers.empty()) return;
  const auto is_marker = [&](const Point& point) {
    return std::any_of(markers.begin(), markers.end(), [&](const Vector3f& m) { return m.cast<double>() == point.p; });
  };
  points_.erase(std::remove_if(points_.begin(), points_.end(), is_marker), points_.end());
}

}  // namespace epcc
