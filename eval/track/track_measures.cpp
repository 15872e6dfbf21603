// SPDX-License-Identifier: BSD-3-Clause
// The newest frame is compared with those at every lag.
#include "eval/track/track_measures.h"

#include <algorithm>

#include "datasets/support/input_error.h"

namespace epcc {
namespace {

constexpr std::size_t kMostFrames = 100;
constexpr double kWatched = 1.0;  // s between the frames whose labels are compared for switches

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

// Against the latest frame of the window that is a second old.
void TrackMeasures::countSwitches(const Seen& later, const PlaneTracker& tracker) {
  for (auto it = window_.rbegin(); it != window_.rend(); ++it) {
    if (!*it || later.time - (*it)->time < kWatched - 1e-6) continue;
    const double seconds = later.time - (*it)->time;
    if (seconds > 1.5 * kWatched) return;
    const std::vector<std::int32_t> shared = sharedPixels((*it)->view, later.view);
    as_written_ += labelSwitches(shared, (*it)->lasting, later.lasting, seconds);
    as_known_ += labelSwitches(shared, asKnown(**it, tracker), asKnown(later, tracker), seconds);
    return;
  }
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
  countSwitches(seen, tracker);
  if (!read.frame.labels.empty()) {
    truth_.add(read.frame.labels, seen.lasting.labels, read.time);
    ++truth_frames_;
  }
  window_.emplace_back(std::move(seen));
}

}  // namespace epcc
