// SPDX-License-Identifier: BSD-3-Clause
// The planes that outlines are drawn on, in the scan frame, and the places of pixel corners on them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "epcc_segmentation/surface_polygon.h"
#include "geometry/pixel_rays.h"

namespace epcc {

/// The planes of a frame and where pixel corners lie on them. Labels count from 1.
class OutlinePlanes {
 public:
  /// `labels` in the order of the scan. All must outlive it.
  OutlinePlanes(const PixelRays& rays, const DepthFrame& frame, const PlaneSegmentation& segmentation,
                const std::vector<std::int32_t>& labels, OutlinePlacement placement);

  /// q of each plane; nothing of one that goes through the sensor.
  const std::vector<std::optional<Eigen::Vector3d>>& inverseDepths() const { return q_; }
  bool exists(int label) const { return q_[static_cast<std::size_t>(label - 1)].has_value(); }
  const Eigen::Vector3d& q(int label) const { return *q_[static_cast<std::size_t>(label - 1)]; }
  const PlaneBasis& basis(int label) const { return bases_[static_cast<std::size_t>(label - 1)]; }
  /// The sum of the footprints of the region's pixels, square metres.
  double pixelArea(int label) const { return pixel_areas_[static_cast<std::size_t>(label - 1)]; }

  /// A corner up and left of the pixel (row, column), or a place less than a pixel from it (columns, rows), on the
  /// plane, in the scan frame.
  Eigen::Vector3d corner(int label, int row, int column, const Eigen::Vector2d& shift = Eigen::Vector2d::Zero()) const;
  /// A point of the scan frame in the plane's basis.
  Eigen::Vector2d flat(int label, const Eigen::Vector3d& scan_point) const;

 private:
  struct FlatMap {
    Eigen::Matrix<double, 2, 3> turn;
    Eigen::Vector2d shift;
  };
  double measuredAt(int label, int row, int column) const;
  void measureRegions();

  const PixelRays& rays_;
  const std::vector<std::int32_t>& labels_;
  OutlinePlacement placement_;
  std::vector<std::optional<Eigen::Vector3d>> q_;
  std::vector<PlaneBasis> bases_;
  std::vector<FlatMap> maps_;
  std::vector<double> pixel_areas_;
  std::vector<double> least_w_;  // of a corner: beyond the horizon there is none
};

}  // namespace epcc
