// SPDX-License-Identifier: BSD-3-Clause
// Every so many rows and columns of the labels.
#include "over_time/keyframe.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "inverse_depth/sample_grid.h"

namespace epcc {

int keyframeStep(const PlaneSegmentation& segmentation) {
  return strideFor(longerSide(segmentation.width, segmentation.height), 0);
}

Keyframe::Keyframe(const PlaneSegmentation& segmentation, const std::vector<int>& tracks,
                   const Eigen::Isometry3d& camera)
    : track_of_plane(tracks), pose(camera) {
  const int step = keyframeStep(segmentation);
  width = std::max(1, segmentation.width / step);
  height = std::max(1, segmentation.height / step);
  const auto pitch = static_cast<std::size_t>(segmentation.width);
  auto list = std::make_shared<std::vector<std::int32_t>>();
  list->reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) {
    const int pixel_row = std::min(segmentation.height - 1, row * step + step / 2);
    const std::int32_t* pixels = segmentation.labels.data() + pitch * static_cast<std::size_t>(pixel_row);
    for (int column = 0; column < width; ++column)
      list->push_back(pixels[std::min(segmentation.width - 1, column * step + step / 2)]);
  }
  labels = std::move(list);
}

}  // namespace epcc
