// SPDX-License-Identifier: BSD-3-Clause
// The pose of a scanner from its rings, which are cones about its axis, and its columns, which are planes through it.
#pragma once

#include <Eigen/Core>

#include "geometry/ray_tables.h"

namespace epcc {

/// The scanner's frame with the axis up: x forward, y left.
Eigen::Matrix3d axesAbout(const Eigen::Vector3d& up);

/// The axis of a scanner in a known place: about it the unit rays of a ring all have the same height, whatever their
/// azimuth, so that it is the direction in which the rays scatter least about the means of their rings.
PoseHypothesis scannerAt(const PointLattice& lattice, const Eigen::Vector3d& origin, bool rings_are_columns);

/// Axis and place of a scanner from the planes of its columns, which all contain the axis, and its height on the axis
/// from the rings, whose height grows with the distance from the axis from a common start. Rough where rings are ahead
/// of each other.
PoseHypothesis scannerFromColumns(const PointLattice& lattice, bool rings_are_columns);

/// Moves a scanner's pose to where azimuth and elevation of the lattice's points fit their tables best.
void refineScanner(const PointLattice& lattice, PoseHypothesis& pose);

}  // namespace epcc
