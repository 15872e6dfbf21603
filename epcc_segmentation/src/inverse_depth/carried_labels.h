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

/// Carries samples into an earlier frame of the same camera, row by row.
class CarriedLabels {
 public:
  /// `image` is seen from `camera_to_map`. The labels of the view are those of its samples or pixels, as many or few as
  /// there are.
  void begin(const InverseDepthImage& image, const KnownView& view, const Isometry3& camera_to_map);
  /// Per sample of a row: the pixel of the earlier frame that shows it, or -1. Until the next call.
  const std::int32_t* pixels(const InverseDepthImage& image, int row);
  /// The plane that a pixel of the earlier frame was part of, 0 for none and for -1.
  std::int32_t planeAt(std::int32_t pixel) const { return pixel >= 0 ? plane_of_[labels_[pixel]] : 0; }
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

  const std::int32_t* labels_ = nullptr;
  const std::int32_t* plane_of_ = nullptr;
  CarriedRow row_ = {};
  Eigen::Matrix3f turn_;
  std::vector<float> across_;
  std::vector<std::int32_t> pixels_;
};

}  // namespace epcc
