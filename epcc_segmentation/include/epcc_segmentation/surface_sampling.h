// SPDX-License-Identifier: BSD-3-Clause
// Points put onto their planes, and surfaces sampled anew on a regular grid.
#pragma once

#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/export.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/surface_polygon.h"
#include "epcc_segmentation/vectors.h"

namespace epcc {

/// The points of a frame with each labelled pixel's moved onto its plane: orthogonally (Eq. 28) or along its ray (the
/// pixel stays where it is in the image; where the ray does not meet the plane ahead of the sensor, orthogonally).
/// Row-major in the order of the labels, metres, in the frame of the cloud; pixels without a label as they were
/// measured, NaN where nothing is. Empty if the segmentation is not of the frame's size.
EPCC_CORE_EXPORT std::vector<Vector3f> pointsOnPlanes(const DepthFrame& frame, const PlaneSegmentation& segmentation,
                                                      OutlinePlacement placement = OutlinePlacement::Orthogonal);

/// Points of a surface on a square grid, `spacing` metres apart along the basis' axes, which goes through the basis'
/// origin: those inside the polygon or on its border, row by row upwards and in a row along `across`. Two surfaces, or
/// the same one in two frames, differ in their grids. Empty if the spacing is not positive or would give more than
/// `max_points`.
EPCC_CORE_EXPORT std::vector<Vector3> sampleSurface(const SurfacePolygon& surface, double spacing,
                                                    std::size_t max_points = 50 * 1000 * 1000);

}  // namespace epcc
