// SPDX-License-Identifier: BSD-3-Clause
// What a frame shows of its planes, in blocks of pixels, and where these are on a plane.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "epcc_segmentation/depth_frame.h"

namespace epcc {

/// Neighbouring pixels of one plane: rows top..bottom - 1 of columns left..right - 1.
struct PlaneBlock {
  std::int32_t plane = 0;  ///< its number in the frame, from 1
  int top = 0, bottom = 0, left = 0, right = 0;
  bool is_whole = false;  ///< all pixels of a place of the raster; else some of one of its rows
};

/// The blocks of a raster of squares of `step` pixels whose row of squares is `turn`, `turn` + `turns`, ... Where a
/// square has one plane it is a block, else each row of it is cut where the plane changes, so that no block reaches
/// beyond a border. Pixels without plane are in none. `labels` is row-major, the frame's own, 0 none.
std::vector<PlaneBlock> planeBlocks(const std::vector<std::int32_t>& labels, int width, int height, int step, int turn,
                                    int turns);

/// The square of the raster that a block is in.
PlaneBlock squareAround(const PlaneBlock& block, int step);

/// Where the corners of a block are on a plane (a, b, c, d), in order, camera frame; nothing if it is seen too flatly.
std::optional<std::array<Eigen::Vector3d, 4>> footprintOf(const PlaneBlock& block, const PinholeCamera& camera,
                                                          const Eigen::Vector4d& plane);

}  // namespace epcc
