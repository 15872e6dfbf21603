// SPDX-License-Identifier: BSD-3-Clause
// The runs of arcs on common lines as edges.
#pragma once

#include <vector>

#include "epcc_segmentation/plane_edges.h"
#include "geometry/outline_arcs.h"

namespace epcc {

/// In the order of the labels; what has a gap of a few pixels between it is one edge.
std::vector<PlaneEdge> creaseEdges(const PixelRays& rays, const EdgeOptions& options, const OutlineArcs& outlines,
                                   PlaneCreases& creases);

}  // namespace epcc
