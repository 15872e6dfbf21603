// SPDX-License-Identifier: BSD-3-Clause
// The camera that took a cloud, from its points and their pixels.
#pragma once

#include <optional>

#include "geometry/ray_tables.h"

namespace epcc {

/// Resectioning: points and their pixels determine the 3x4 matrix P of (u, v, 1) ~ P (x, y, z, 1) linearly. With
/// P = K [R | -R t] the rows of R are the camera's axes, those of a mirrored picture or one with rows and columns
/// exchanged too. Nothing if no camera sees most of the points in front of it.
std::optional<PoseHypothesis> cameraAnywhere(const PointLattice& lattice);

/// The same for a camera at the origin, (u, v, 1) ~ H (x, y, z): a single plane in view determines H too.
std::optional<PoseHypothesis> cameraAtOrigin(const PointLattice& lattice);

}  // namespace epcc
