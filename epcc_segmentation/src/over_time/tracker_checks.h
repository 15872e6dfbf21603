// SPDX-License-Identifier: BSD-3-Clause
// What a tracker is given, checked.
#pragma once

#include <optional>
#include <string>

#include "epcc_segmentation/plane_tracker.h"

namespace epcc {

/// What is wrong with the parameters, the pose or the time, in words; empty if nothing is.
std::string trackerProblem(const TrackerParameters& parameters, const std::optional<Isometry3>& camera_to_map,
                           double time);

}  // namespace epcc
