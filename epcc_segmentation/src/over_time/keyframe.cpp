// SPDX-License-Identifier: BSD-3-Clause
// Every so many rows and columns of the labels.
#include "over_time/keyframe.h"

#include <algorithm>
#include <cstddef>

#include "inverse_depth/sample_grid.h"
#include "thin_out.h"

namespace epcc {

int keyframeStep(const PlaneSegmentation& segmentation) {
  return strideFor(longerSide(segmentation.width, segmentation.height), 0);
}

void Keyframe::take(const PlaneSegmentation& segmentation, const std::vector<int>& tracks,
                    const Eigen::Isometry3d& camera, const Continuation& continuation) {
  track_of_plane = tracks;
  pose = camera;
  const int step = keyframeStep(segmentation);
  width = std::max(1, segmentation.width / step);
  height = std::max(1, segmentation.height / step);
  const auto pitch = static_cast<std::size_t>(segmentation.width);
  if (labels == nullptr || labels.use_count() > 1) labels = std::make_shared<std::vector<std::int32_t>>();
  labels->resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) {
    const int pixel_row = std::min(segmentation.height - 1, row * step + step / 2);
    const std::int32_t* pixel = segmentation.labels.data() + pitch * static_cast<std::size_t>(pixel_row);
    thinOut(pixel + std::min(segmentation.width - 1, step / 2), width, step, labels->data() + row * width);
  }
  for (const std::int32_t pixel : continuation.waiting)
    leaveOut(pixel / segmentation.width / step, pixel % segmentation.width / step,
             std::max(1, continuation.waiting_side / step));
}

/// A square was not looked at, except for what has a label nevertheless.
void Keyframe::leaveOut(int row, int column, int side) {
  const auto not_looked_at = static_cast<std::int32_t>(track_of_plane.size()) + 1;
  for (int i = row; i < std::min(height, row + side); ++i)
    for (int j = column; j < std::min(width, column + side); ++j) {
      std::int32_t& label =
          (*labels)[static_cast<std::size_t>(i) * static_cast<std::size_t>(width) + static_cast<std::size_t>(j)];
      if (label == 0) label = not_looked_at;
    }
}

}  // namespace epcc
