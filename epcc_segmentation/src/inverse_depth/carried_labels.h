// SPDX-License-Identifier: BSD-3-Clause
// What the samples of a frame were in an earlier one.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/known_planes.h"
#include "inverse_depth/carried_row.h"
#include "inverse_depth/inverse_depth_image.h"

namespace epcc {

/// Instead of a plane: the earlier frame does not show it, or nothing was looked for there.
constexpr std::int32_t kUnseen = kNotLookedAt;

/// Carries samples into an earlier frame of the same camera, row by row.
class CarriedLabels {
 public:
  /// The labels of the view are those of its samples or pixels, as many or few as there are.
  void begin(const InverseDepthImage& image, const KnownView& view);
  /// The image is seen from the one pose, the view from the other, both camera to map.
  void carryFrom(const Isometry3& image_pose, const Isometry3& view_pose);
  /// Per sample `begin` .. `end` - 1 of a row: the plane that it was part of, 0 for none, kUnseen if the view does not
  /// show it or it is not measured. Until the next call.
  const std::int32_t* planes(const InverseDepthImage& image, int row, int begin, int end);
  /// Rays of the samples of a row.
  const float* across() const { return across_.data(); }

 private:
  /// Pixels of a row or column, of which there are `count`, from ray coordinates: offset + factor * coordinate,
  /// rounded down.
  struct PixelOf {
    float offset = 0.0f, factor = 0.0f;
    PixelOf() = default;
    PixelOf(const std::vector<double>& coordinate, int count);
  };

  std::vector<std::int32_t> plane_at_;  // by pixel of the earlier frame, and kUnseen behind the last
  CarriedRow row_ = {};
  Eigen::Matrix3f turn_;
  std::vector<float> across_;
  std::vector<std::int32_t> pixels_, planes_;
};

}  // namespace epcc
