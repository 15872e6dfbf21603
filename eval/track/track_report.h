// SPDX-License-Identifier: BSD-3-Clause
// What epcc_track prints.
#pragma once

#include <string>

#include "eval/track/track_run.h"

namespace epcc {

/// Frames, time, tracks, and the largest of these as a table.
std::string trackSummary(const TrackOptions& options, const TrackResult& result);

/// How far the trajectory found is from the known one; empty if there is none.
std::string trajectorySummary(const TrackResult& result);

/// The measures that were taken, as tables; empty if none were.
std::string measureSummary(const TrackOptions& options, const TrackResult& result);

}  // namespace epcc
