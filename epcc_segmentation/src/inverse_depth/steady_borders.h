// SPDX-License-Identifier: BSD-3-Clause
// Borders that are to stay where they were in earlier frames.
#pragma once

#include <cstdint>

#include "inverse_depth/boundary_refinement.h"

namespace epcc {

/// Of pixels that could be of either plane those around decide, before the candidates are chosen from: else a strip
/// along the line where two planes cross becomes a pixel longer with every pass, and with every frame. A crease alone
/// flips no pixel that has fewer than two of four neighbours of the other label; a pixel with fewer than two of its own
/// leaves it unless that costs `flip_gain` sigma for each neighbour that the other has more.
void askNeighbours(const InverseDepthImage& image, const std::int32_t* labels, double flip_gain,
                   const RefinementMemory::Pixel* pixels, RefinementMemory::Part& part);

}  // namespace epcc
