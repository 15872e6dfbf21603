// SPDX-License-Identifier: BSD-3-Clause
// The numbers of a row.
#include "inverse_depth/carried_labels.h"

#include <Eigen/Geometry>
#include <cstddef>

#include "inverse_depth/relabelling.h"

namespace epcc {

CarriedLabels::PixelOf::PixelOf(const std::vector<double>& coordinate, int count) {
  const auto samples = static_cast<double>(coordinate.size());
  const double span = coordinate.back() - coordinate.front();
  const double per_coordinate = span > 0.0 ? (samples - 1.0) / span : 0.0;
  const double pixels = count / samples;  // that a sample stands for
  factor = static_cast<float>(pixels * per_coordinate);
  offset = static_cast<float>(pixels * (0.5 - per_coordinate * coordinate.front()));
}

void CarriedLabels::begin(const InverseDepthImage& image, const KnownView& view) {
  across_.assign(image.across.begin(), image.across.end());
  const PixelOf column_of(image.across, view.width), row_of(image.along, view.height);
  row_.column_offset = column_of.offset;
  row_.column_factor = column_of.factor;
  row_.row_offset = row_of.offset;
  row_.row_factor = row_of.factor;
  row_.frame_width = view.width;
  row_.frame_height = view.height;
  plane_at_.resize(view.labels->size() + 1);
  relabelPixels(view.labels->data(), view.labels->size(), view.plane_of_label.data(), plane_at_.data());
  plane_at_.back() = kUnseen;
  pixels_.resize(across_.size() + 16);
  planes_.resize(across_.size());
}

void CarriedLabels::carryFrom(const Isometry3& image_pose, const Isometry3& view_pose) {
  const Eigen::Isometry3d to_earlier = Eigen::Isometry3d(view_pose).inverse() * Eigen::Isometry3d(image_pose);
  turn_ = to_earlier.linear().cast<float>();
  const Eigen::Vector3f shift = to_earlier.translation().cast<float>();
  for (int k = 0; k < 3; ++k) {
    row_.along_row[k] = turn_(k, 0);
    row_.shift[k] = shift(k);
  }
}

const std::int32_t* CarriedLabels::planes(const InverseDepthImage& image, int row, int begin, int end) {
  row_.along = static_cast<float>(image.along[static_cast<std::size_t>(row)]);
  for (int k = 0; k < 3; ++k) row_.begin[k] = turn_(k, 1) * row_.along + turn_(k, 2);
  row_.w = image.w.data() + image.index(row, begin);
  row_.across = across_.data() + begin;
  row_.width = end - begin;
  placesInEarlierFrame(row_, pixels_.data());
  const std::int32_t* const plane_at = plane_at_.data();
  const std::int32_t* const pixels = pixels_.data();
  std::int32_t* const planes = planes_.data();
  for (int k = 0; k < row_.width; ++k) planes[k] = plane_at[pixels[k]];
  return planes;
}

}  // namespace epcc
