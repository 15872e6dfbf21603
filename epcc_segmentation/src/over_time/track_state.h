// SPDX-License-Identifier: BSD-3-Clause
// A track with what decides about it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "epcc_segmentation/plane_tracker.h"

namespace epcc {

/// Which cells of a plane have been seen, a square grid on the plane as it was first seen.
class SeenCells {
 public:
  SeenCells() = default;
  SeenCells(const Eigen::Vector4d& plane, const Eigen::Vector3d& origin, double size);
  void add(const Eigen::Vector3d& point) { cells_.insert(keyOf(cellOf(point))); }
  /// Whether its cell or one beside it has been seen.
  bool isNear(const Eigen::Vector3d& point) const;
  void join(const SeenCells& other);
  std::size_t count() const { return cells_.size(); }

 private:
  using Cell = Eigen::Vector2i;
  Cell cellOf(const Eigen::Vector3d& point) const;
  static std::uint64_t keyOf(const Cell& cell) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.x())) << 32) |
           static_cast<std::uint32_t>(cell.y());
  }
  Eigen::Vector3d pointOf(std::uint64_t key) const;

  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d x_ = Eigen::Vector3d::UnitX(), y_ = Eigen::Vector3d::UnitY();
  double size_ = 1.0;
  std::unordered_set<std::uint64_t> cells_;
};

struct TrackState : PlaneTrack {
  SeenCells cells;
  double weight = 0.0;  ///< pixels over all frames
  int other = -1;       ///< the track that it was merged into

  /// Takes in what a frame saw of it. Its memory is of `memory` frames: what lies farther back counts less, so that the
  /// plane is that of where the camera is now; but what is not seen anew is not forgotten.
  void join(const MapPlane& measured, const Eigen::Vector3d& place, double memory);
};

/// Squared difference of two planes of the map that are seen from the same side, in units of its covariance, about
/// `place`; infinite if they are seen from opposite sides.
double squaredDifference(const MapPlane& a, const MapPlane& b, const Eigen::Vector3d& place);

}  // namespace epcc
