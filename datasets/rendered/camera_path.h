// SPDX-License-Identifier: BSD-3-Clause
// Ways of a camera through a rendered scene.
#pragma once

#include <string>
#include <vector>

#include "datasets/files/trajectory_file.h"
#include "datasets/rendered/scene_geometry.h"

namespace epcc {

/// Names of the built-in paths: a camera held in the hand that sways about its place (sway), goes round what it looks
/// at, or a place 1.5 m ahead if that is nearer, by 25 degrees to either side (orbit), or walks a third of the way into
/// the scene and back (walk). Each begins at the scene's own pose and is back there after ten seconds.
std::vector<std::string> pathNames();

/// The scene's own pose: camera to world, x right, y down, z forward.
Eigen::Isometry3d cameraToWorld(const CameraPose& pose);

/// A built-in path at times 0, 1 / rate, ...; std::invalid_argument for an unknown name.
Trajectory builtInPath(const std::string& name, const Scene& scene, std::size_t frames, double rate);

/// A recorded path at times 0, 1 / rate, ... from its start, moved as a whole so that it begins at the scene's own
/// pose; between two poses straight on. `frames` 0: to its end.
Trajectory pathAlong(const Trajectory& recorded, const Scene& scene, std::size_t frames, double rate);

}  // namespace epcc
