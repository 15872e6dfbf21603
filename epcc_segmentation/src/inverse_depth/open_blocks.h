// SPDX-License-Identifier: BSD-3-Clause
// The parts of an image that known planes do not explain.
#pragma once

#include <cstdint>
#include <vector>

#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/region_map.h"

namespace epcc {

/// Instead of a label: there is no plane, and none is to be looked for.
constexpr std::int32_t kPassedOver = -1;

/// Keeps its memory from frame to frame.
class OpenBlocks {
 public:
  /// Leaves of the image the samples without a label, where there are enough of them to be something. False, and the
  /// image is as it was, if there are none. kPassedOver becomes 0.
  bool hideRest(InverseDepthImage& image, RegionMap& map);
  /// Takes that back.
  void showAll(InverseDepthImage& image);

 private:
  bool mark(const InverseDepthImage& image, const RegionMap& map);

  std::vector<float> all_w_;
  std::vector<int> counts_;         ///< of each block's samples
  std::vector<std::uint8_t> open_;  ///< per block
};

}  // namespace epcc
