// SPDX-License-Identifier: BSD-3-Clause
// The newest frame is compared with those at every lag.
#include "eval/track/track_measures.h"

#include <algorithm>

#include "datasets/support/input_error.h"
#include "eval/measures/depth_alignment.h"

namespace epcc {
namespace {

constexpr std::size_t kMostFrames = 100;
constexpr double kWatched = 1.0;  // s between the frames whose labels are compared for switches, and their poses
constexpr long kAlignEvery = 5;   // frames

LabelSwitches& operator+=(LabelSwitches& sums, const LabelSwitches& other) {
  sums.switches += other.switches;
  sums.seconds += other.seconds;
  return sums;
}

}  // namespace

TrackMeasures::TrackMeasures(const TrackOptions& options, const std::optional<SensorModel>& sensor)
    : compare_single_(options.compare_single), sensor_(sensor), extractor_(options.parameters, sensor) {
  for (const int lag : options.lags) {
    lags_.emplace_back();
    lags_.back().lag = lag;
    longest_ = std::max(longest_, static_cast<std::size_t>(lag));
  }
}

/// By the labels that its planes have by now, those included that had none then.
LastingRegions TrackMeasures::asKnown(const Seen& seen, const PlaneTracker& tracker) {
  std::vector<std::int32_t> label_of_plane;
  for (const int track : seen.track_of_plane) label_of_plane.push_back(tracker.labelOf(track).value_or(0));
  return lastingRegions(seen.regions, label_of_plane);
}

void TrackMeasures::compare(const Seen& earlier, const Seen& later, LagMeasures& sums, const PlaneTracker& tracker) {
  const std::vector<std::int32_t> shared = sharedPixels(earlier.view, later.view);
  const Eigen::Isometry3d later_from_earlier = later.view.pose.inverse() * earlier.view.pose;
  sums.tracked += repeatability(shared, earlier.regions, later.regions, later_from_earlier);
  if (earlier.single && later.single)
    sums.single += repeatability(shared, *earlier.single, *later.single, later_from_earlier);
  sums.as_written += lastingRepeatability(shared, earlier.lasting, later.lasting);
  sums.as_known += lastingRepeatability(shared, asKnown(earlier, tracker), asKnown(later, tracker));
}

/// The latest frame of the window that is a second old; none if there is a gap.
const TrackMeasures::Seen* TrackMeasures::aSecondBefore(const Seen& later) const {
  for (auto it = window_.rbegin(); it != window_.rend(); ++it) {
    if (!*it || later.time - (*it)->time < kWatched - 1e-6) continue;
    return later.time - (*it)->time > 1.5 * kWatched ? nullptr : &**it;
  }
  return nullptr;
}

void TrackMeasures::countSwitches(const Seen& earlier, const Seen& later, const PlaneTracker& tracker) {
  const double seconds = later.time - earlier.time;
  const std::vector<std::int32_t> shared = sharedPixels(earlier.view, later.view);
  as_written_ += labelSwitches(shared, earlier.lasting, later.lasting, seconds);
  as_known_ += labelSwitches(shared, asKnown(earlier, tracker), asKnown(later, tracker), seconds);
}

void TrackMeasures::align(const Seen& earlier, const Seen& later, const SensorModel& sensor) {
  if (frames_ % kAlignEvery != 0 || !earlier.is_determined || !later.is_determined) return;
  const Eigen::Isometry3d known = later.view.pose.inverse() * earlier.view.pose;
  const Eigen::Isometry3d tracked = later.tracked.inverse() * earlier.tracked;
  const DepthAlignment best = alignDepth(earlier.view, later.view, sensor, {known, tracked});
  const auto compare = [&](const Eigen::Isometry3d& pose, std::vector<double>& metres, std::vector<double>& degrees,
                           std::vector<double>& misfit) {
    const PoseDifference error = poseDifference(pose.inverse(), best.to_from.inverse());
    metres.push_back(error.metres);
    degrees.push_back(error.degrees);
    misfit.push_back(depthMisfit(earlier.view, later.view, sensor, pose));
  };
  compare(known, aligned_.known_metres, aligned_.known_degrees, aligned_.known_misfit);
  compare(tracked, aligned_.tracked_metres, aligned_.tracked_degrees, aligned_.tracked_misfit);
  aligned_.aligned_misfit.push_back(best.misfit);
}

void TrackMeasures::add(const SequenceFrame& read, const TrackedFrame& tracked, const PlaneTracker& tracker) {
  // All lags are kept, and the last second as far as that does not take many frames more.
  while (window_.size() > longest_ &&
         (window_.size() > kMostFrames || !window_[1] || read.time - window_[1]->time > kWatched - 1e-6))
    window_.pop_front();
  if (!read.pose) {
    window_.emplace_back();
    return;
  }
  ++frames_;
  const DepthFrame frame = frameView(read.frame);
  const SensorModel model = sensor_ ? *sensor_ : stream_.update(frame).model();
  Seen seen;
  seen.time = read.time;
  seen.view = {read.frame.camera.camera, *read.pose, read.frame.depth};
  seen.tracked = tracked.pose.camera_to_map;
  seen.is_determined = openDirections(tracked.pose_information).empty();
  seen.regions = seenRegions(seen.view, tracked.segmentation, model);
  seen.track_of_plane = tracked.track_of_plane;
  seen.lasting = lastingRegions(seen.regions, tracked.label_of_plane);
  if (compare_single_) {
    PlaneSegmentation single;
    if (!extractor_.extract(frame, single)) throw InputError(read.frame.name, "frame", extractor_.error());
    seen.single = seenRegions(seen.view, single, model);
  }
  for (LagMeasures& sums : lags_) {
    const auto lag = static_cast<std::size_t>(sums.lag);
    if (window_.size() >= lag && window_[window_.size() - lag])
      compare(*window_[window_.size() - lag], seen, sums, tracker);
  }
  if (const Seen* earlier = aSecondBefore(seen)) {
    countSwitches(*earlier, seen, tracker);
    align(*earlier, seen, model);
  }
  if (!read.frame.labels.empty()) {
    truth_.add(read.frame.labels, seen.lasting.labels, read.time);
    ++truth_frames_;
  }
  window_.emplace_back(std::move(seen));
}

}  // namespace epcc
