// SPDX-License-Identifier: BSD-3-Clause
// From where a map is looked at: which way is up, and two views without perspective.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "datasets/files/trajectory_file.h"
#include "eval/track/track_map.h"

namespace epcc {

/// Axes of a picture without perspective: right, up, and out of it, towards the viewer; right-handed unit vectors.
struct MapView {
  Eigen::Vector3d right, up, out;
};

/// Which way is up: against the mean of the camera's own downward axis; where the floor or ceiling of most area is
/// within 30 degrees of it, exactly along its normal.
Eigen::Vector3d upwards(const std::vector<MappedTrack>& tracks, const Trajectory& trajectory);

/// From above; the picture's up is the horizontal direction that the camera looked into on average.
MapView viewFromAbove(const Eigen::Vector3d& up, const Trajectory& trajectory);
/// The same, tilted to look down by 40 degrees and from one side.
MapView obliqueView(const Eigen::Vector3d& up, const Trajectory& trajectory);

}  // namespace epcc
