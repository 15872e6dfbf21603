// SPDX-License-Identifier: BSD-3-Clause
// One pass over the frames of a sequence: what comes out is written as it comes, or summed up.
#pragma once

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "eval/measures/lasting_labels.h"
#include "eval/track/track_measures.h"

namespace epcc {

/// What is left of a run once its frames are forgotten.
struct TrackResult {
  std::vector<std::string> names;   ///< of the frames that were tracked, in the tracker's numbers
  std::vector<std::size_t> places;  ///< of the same in the input
  Trajectory trajectory;            ///< found
  std::vector<int> open;            ///< of each pose of it, how many directions the planes leave open
  Trajectory truth;                 ///< known, where it is
  std::vector<MappedTrack> tracks;
  SquaredErrors squared_errors;
  double error_scale = 1.0;
  ValueCounts microseconds;                 ///< the tracker's, of each frame
  std::string sensor;                       ///< its name
  std::unique_ptr<TrackMeasures> measures;  ///< if they were asked for
  long without_start = 0;                   ///< frames left out because they come before the first pose of a trajectory
  std::vector<std::string> jumps;           ///< frames at which the given poses jumped
  std::vector<std::string> lost;            ///< frames whose planes are not where they are expected
  long without_depth = 0;                   ///< frames that show nothing
  long problems = 0;                        ///< frames that could not be used
  std::size_t doubtful = 0;                 ///< frames of which something speaks against their planes
  std::string first_doubtful, first_doubt;  ///< the first of them, and what
};

/// Tracks the frames and writes their label images and times.csv into the folder. A frame that cannot be used is told
/// on `err` and left out. Throws OutputError, and InputError if no frame could be used.
TrackResult runTracker(const TrackOptions& options, const TrackInput& input, std::ostream& err);

}  // namespace epcc
