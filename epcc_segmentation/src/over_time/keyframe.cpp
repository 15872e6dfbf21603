// SPDX-License-Identifier: BSD-3-Clause
// Every so many rows and columns of the labels.
#include "over_time/keyframe.h"

#include <algorithm>
#include <cstddef>

#include "inverse_depth/sample_grid.h"

namespace epcc {

int keyframeStep(const PlaneSegmentation& segmentation) {
  return strideFor(longerSide(segmentation.width, segmentation.height), 0);
}

void Keyframe::take(const PlaneSegmentation& segmentation, const std::vector<int>& tracks,
                    const Eigen::Isometry3d& camera) {
  track_of_plane = tracks;
  pose = camera;
  const int step = keyframeStep(segmentation);
  width = std::max(1, segmentation.width / step);
  height = std::max(1, segmentation.height / step);
  const auto pitch = static_cast<std::size_t>(segmentation.width);
  if (labels == nullptr || labels.use_count() > 1) labels = std::make_shared<std::vector<std::int32_t>>();
  labels->resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::int32_t* next = labels->data();
  for (int row = 0; row < height; ++row) {
    const int pixel_row = std::min(segmentation.height - 1, row * step + step / 2);
    const std::int32_t* pixel = segmentation.labels.data() + pitch * static_cast<std::size_t>(pixel_row);
    pixel += std::min(segmentation.width - 1, step / 2);
    for (int column = 0; column < width; ++column, pixel += step) *next++ = *pixel;
  }
}

}  // namespace epcc
