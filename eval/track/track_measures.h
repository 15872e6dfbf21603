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

/// Relative poses over a second beside those at which the depth images themselves fit each other best: of the known
/// poses and of the trajectory. Every fifth frame, where the planes leave no direction open at either end.
struct AlignedErrors {
  std::vector<double> known_metres, known_degrees, tracked_metres, tracked_degrees;
  std::vector<double> known_misfit, tracked_misfit, aligned_misfit;  ///< depthMisfit()
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
  const AlignedErrors& alignedErrors() const { return aligned_; }

 private:
  struct Seen {
    double time = 0.0;
    PosedView view;
    Eigen::Isometry3d tracked = Eigen::Isometry3d::Identity();  ///< pose in the map
    bool is_determined = false;                                 ///< by the planes, in all directions
    SeenRegions regions;
    std::vector<int> track_of_plane;
    LastingRegions lasting;  ///< by the labels that its planes had then
    std::optional<SeenRegions> single;
  };

  static LastingRegions asKnown(const Seen& seen, const PlaneTracker& tracker);
  void compare(const Seen& earlier, const Seen& later, LagMeasures& sums, const PlaneTracker& tracker);
  const Seen* aSecondBefore(const Seen& later) const;
  void countSwitches(const Seen& earlier, const Seen& later, const PlaneTracker& tracker);
  void align(const Seen& earlier, const Seen& later, const SensorModel& sensor);

  bool compare_single_;
  std::optional<SensorModel> sensor_;
  SensorEstimator stream_;
  PlaneExtractor extractor_;
  std::size_t longest_ = 0;
  std::deque<std::optional<Seen>> window_;  ///< the last frames, nothing for those without a pose
  std::vector<LagMeasures> lags_;
  SwitchCounter truth_;
  LabelSwitches as_written_, as_known_;
  AlignedErrors aligned_;
  long frames_ = 0, truth_frames_ = 0;
};

}  // namespace epcc
