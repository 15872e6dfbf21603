// SPDX-License-Identifier: BSD-3-Clause
// How steady the labels of a run are, measured while it goes on: a window of frames is kept, nothing else.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "eval/measures/lasting_labels.h"
#include "eval/measures/trajectory_errors.h"
#include "eval/track/track_input.h"
#include "eval/track/track_map.h"

namespace epcc {

/// Of all pairs of frames a lag apart.
struct LagMeasures {
  int lag = 0;
  Repeatability single;             ///< frames segmented one by one
  Repeatability tracked;            ///< planes of the frames of the run, whatever their labels
  LastingRepeatability as_written;  ///< with equal labels
  LastingRepeatability as_known;    ///< labels as they are known at the time of the later frame
};

/// Takes the frames of a run that have poses.
class TrackMeasures {
 public:
  TrackMeasures(const TrackOptions& options, const std::optional<SensorModel>& sensor);

  /// The frame that the tracker has just taken. Counts nothing of a frame without a pose. InputError if the frame
  /// cannot be segmented on its own (--compare-single).
  void add(const SequenceFrame& read, const TrackedFrame& tracked, const PlaneTracker& tracker);

  const std::vector<LagMeasures>& lags() const { return lags_; }
  long frames() const { return frames_; }
  bool hasTruth() const { return truth_frames_ > 0; }
  const LabelSwitches& switchesOfTruth() const { return truth_.result(); }
  const LabelSwitches& switchesAsWritten() const { return as_written_; }
  const LabelSwitches& switchesAsKnown() const { return as_known_; }

 private:
  struct Seen {
    double time = 0.0;
    PosedView view;
    SeenRegions regions;
    std::vector<int> track_of_plane;
    LastingRegions lasting;  ///< by the labels that its planes had then
    std::optional<SeenRegions> single;
  };

  static LastingRegions asKnown(const Seen& seen, const PlaneTracker& tracker);
  void compare(const Seen& earlier, const Seen& later, LagMeasures& sums, const PlaneTracker& tracker);
  void countSwitches(const Seen& later, const PlaneTracker& tracker);

  bool compare_single_;
  std::optional<SensorModel> sensor_;
  SensorEstimator stream_;
  PlaneExtractor extractor_;
  std::size_t longest_ = 0;
  std::deque<std::optional<Seen>> window_;  ///< the last frames, nothing for those without a pose
  std::vector<LagMeasures> lags_;
  SwitchCounter truth_;
  LabelSwitches as_written_, as_known_;
  long frames_ = 0, truth_frames_ = 0;
};

}  // namespace epcc
