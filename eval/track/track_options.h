// SPDX-License-Identifier: BSD-3-Clause
// The command line of epcc_track.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "datasets/files/trajectory_file.h"
#include "datasets/sources/reading_options.h"
#include "epcc_segmentation/plane_tracker.h"

namespace epcc {

/// What epcc_track is asked to do.
struct TrackOptions {
  std::string folder;                               ///< FOLDER or FORMAT:FOLDER
  std::string out;                                  ///< folder
  std::string poses;                                ///< trajectory; empty: the frames' own poses
  bool pose_free = false;                           ///< the tracker is not told poses, known or not
  double max_time_difference = kMaxTimeDifference;  ///< of a frame and a pose, s
  double rate = 30.0;                               ///< frames a second where frames have no times
  std::size_t first = 0;                            ///< frame of the data set to start with
  std::size_t every = 1;                            ///< each n-th from there on
  std::size_t count = 0;                            ///< so many at most; 0: all
  ReadingOptions reading;
  std::string noise;  ///< sensor model as on the command line; empty: the first frame's own, else auto
  Parameters parameters;
  TrackerParameters tracker;
  bool online = false;    ///< labels stay as they were written
  bool overlays = false;  ///< a picture of each frame
  double cell = 0.02;     ///< of the map, m
  bool measure = false;
  bool compare_single = false;
  std::vector<int> lags;  ///< of the measures, frames
};

/// Reads the command line. Returns an exit code if the program is done (help, version, or an error that has been
/// reported on `err` in one line), nothing if `options` is to be carried out.
std::optional<int> parseTrackOptions(int argc, const char* const* argv, TrackOptions& options, std::ostream& out,
                                     std::ostream& err);

}  // namespace epcc
