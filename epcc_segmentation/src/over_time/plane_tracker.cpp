// SPDX-License-Identifier: BSD-3-Clause
// The steps of a frame in their order.
#include "epcc_segmentation/plane_tracker.h"

#include <algorithm>
#include <exception>
#include <new>

#include "over_time/tracker_checks.h"
#include "over_time/tracker_state.h"

namespace epcc {

const char* inWords(TrackEnd end) {
  switch (end) {
    case TrackEnd::Merged:
      return "merged";
    case TrackEnd::NotConfirmed:
      return "not confirmed";
    case TrackEnd::Clutter:
      return "clutter";
    case TrackEnd::None:
      break;
  }
  return "none";
}

PlaneTracker::PlaneTracker(const TrackerParameters& tracker, const Parameters& parameters,
                           const std::optional<SensorModel>& sensor)
    : state_(std::make_unique<State>(tracker, parameters, sensor)) {}
PlaneTracker::~PlaneTracker() = default;
PlaneTracker::PlaneTracker(PlaneTracker&&) noexcept = default;
PlaneTracker& PlaneTracker::operator=(PlaneTracker&&) noexcept = default;

bool PlaneTracker::track(const DepthFrame& frame, const std::optional<Isometry3>& camera_to_map, double time,
                         TrackedFrame& result) {
  State& s = *state_;
  bool changes_map = false;
  const auto fail = [&](Status status, const char* what) {
    if (changes_map) s.forget();
    s.status = status;
    s.error = what;
    return false;
  };
  try {
    s.status = Status::InvalidParameters;
    s.error = trackerProblem(s.tracker, camera_to_map, time);
    if (s.error.empty() && time < s.last_time) s.error = "the time is before that of the last frame";
    if (!s.error.empty()) return false;
    if (!s.segment(frame, camera_to_map, result)) {
      s.status = s.extractor.status();
      s.error = s.extractor.error();
      return false;
    }
    changes_map = true;
    s.takePose(result);
    s.learnErrorScale(result);
    s.assign(s.seenPlanes(frame, result), time);
    s.judge();
    s.label(result);
    s.remember(result.segmentation);
    ++s.frame;
    s.last_time = time;
    s.status = Status::Ok;
    return true;
  } catch (const std::bad_alloc&) {
    return fail(Status::OutOfMemory, "out of memory");  // short enough to need none
  } catch (const std::exception& error) {
    return fail(Status::Failed, error.what());
  }
}

std::vector<PlaneTrack> PlaneTracker::tracks() const {
  std::vector<PlaneTrack> list;
  for (const TrackState& track : state_->tracks.all()) {
    if (track.label == 0) continue;
    list.push_back(track);
    if (track.end == TrackEnd::Merged)
      list.back().merged_into = state_->tracks.at(state_->tracks.last(track.other)).label;
  }
  std::sort(list.begin(), list.end(), [](const PlaneTrack& a, const PlaneTrack& b) { return a.label < b.label; });
  return list;
}

std::optional<std::int32_t> PlaneTracker::labelOf(int track) const noexcept {
  const MapTracks& tracks = state_->tracks;
  if (track < 0 || static_cast<std::size_t>(track) >= tracks.all().size()) return std::nullopt;
  const TrackState& last = tracks.at(tracks.last(track));
  if (last.label == 0 && last.end == TrackEnd::None) return std::nullopt;
  return last.label;
}

Status PlaneTracker::status() const noexcept {
  return state_->status;
}

const std::string& PlaneTracker::error() const noexcept {
  return state_->error;
}

const StageTimes& PlaneTracker::times() const noexcept {
  return state_->extractor.times();
}

const SensorModel& PlaneTracker::sensor() const noexcept {
  return state_->extractor.sensor();
}

double PlaneTracker::errorScale() const noexcept {
  return state_->error_scale;
}

}  // namespace epcc
