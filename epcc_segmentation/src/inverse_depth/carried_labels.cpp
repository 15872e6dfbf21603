// SPDX-License-Identifier: BSD-3-Clause
// The numbers of a row.
#include "inverse_depth/carried_labels.h"

#include <Eigen/Geometry>
#include <cstddef>

namespace epcc {

CarriedLabels::PixelOf::PixelOf(const std::vector<double>& coordinate, int count) {
  const auto samples = static_cast<double>(coordinate.size());
  const double span = coordinate.back() - coordinate.front();
  const double per_coordinate = span > 0.0 ? (samples - 1.0) / span : 0.0;
  const double pixels = count / samples;  // that a sample stands for
  factor = static_cast<float>(pixels * per_coordinate);
  offset = static_cast<float>(pixels * (0.5 - per_coordinate * coordinate.front()));
}

void CarriedLabels::begin(const InverseDepthImage& image, const KnownView& view, const Isometry3& camera_to_map) {
  const Eigen::Isometry3d to_earlier =
      Eigen::Isometry3d(view.camera_to_map).inverse() * Eigen::Isometry3d(camera_to_map);
  turn_ = to_earlier.linear().cast<float>();
  across_.assign(image.across.begin(), image.across.end());
  const Eigen::Vector3f shift = to_earlier.translation().cast<float>();
  for (int k = 0; k < 3; ++k) {
    row_.along_row[k] = turn_(k, 0);
    row_.shift[k] = shift(k);
  }
  const PixelOf column_of(image.across, view.width), row_of(image.along, view.height);
  row_.column_offset = column_of.offset;
  row_.column_factor = column_of.factor;
  row_.row_offset = row_of.offset;
  row_.row_factor = row_of.factor;
  row_.across = across_.data();
  row_.width = image.width;
  row_.frame_width = view.width;
  row_.frame_height = view.height;
  labels_ = view.labels->data();
  plane_of_ = view.plane_of_label.data();
  pixels_.resize(across_.size() + 16);
}

const std::int32_t* CarriedLabels::pixels(const InverseDepthImage& image, int row) {
  row_.along = static_cast<float>(image.along[static_cast<std::size_t>(row)]);
  for (int k = 0; k < 3; ++k) row_.begin[k] = turn_(k, 1) * row_.along + turn_(k, 2);
  row_.w = image.w.data() + image.index(row, 0);
  placesInEarlierFrame(row_, pixels_.data());
  return pixels_.data();
}

}  // namespace epcc
