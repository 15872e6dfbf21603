// SPDX-License-Identifier: BSD-3-Clause
// Decisions by chi-square, by place and by votes.
#include "over_time/map_tracks.h"

#include <algorithm>

namespace epcc {

namespace {

constexpr double kMaxSquare = 16.3;    // of a chi^2 of three parameters, once in a thousand
constexpr double kCellOfDepth = 0.05;  // size of a cell by the distance that it was first seen from
constexpr double kLeastCosine = 0.94;  // 20 degrees
constexpr double kMinOverlap = 0.3;    // of a plane's places, where a track was seen before
constexpr double kMostOfVotes = 0.5;
constexpr double kLeastCell = 1e-3;  // metres

}  // namespace

int MapTracks::last(int track) const {
  while (at(track).end == TrackEnd::Merged) track = at(track).other;
  return track;
}

int MapTracks::alive(int track) const {
  track = last(track);
  return at(track).end == TrackEnd::None ? track : -1;
}

int MapTracks::find(const SeenInMap& seen, bool young_too) const {
  int best = -1;
  double best_overlap = kMinOverlap;
  const Eigen::Vector3d& middle = seen.places[seen.places.size() / 2];
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    const TrackState& track = tracks_[k];
    if (track.end != TrackEnd::None || (track.label == 0 && !young_too)) continue;
    if (squaredDifference(seen.again, track.plane, middle) > kMaxSquare) continue;
    const auto near = std::count_if(seen.places.begin(), seen.places.end(),
                                    [&track](const Eigen::Vector3d& place) { return track.cells.isNear(place); });
    const double overlap = static_cast<double>(near) / static_cast<double>(seen.places.size());
    if (overlap > best_overlap) {
      best_overlap = overlap;
      best = static_cast<int>(k);
    }
  }
  return best;
}

int MapTracks::birth(const SeenInMap& seen, const Eigen::Vector3d& camera, const FrameTime& now) {
  TrackState track;
  track.plane = seen.plane;
  track.first_frame = track.last_frame = now.frame;
  track.first_time = now.seconds;
  const Eigen::Vector3d& origin = seen.places.front();
  track.cells =
      SeenCells(seen.plane.coefficients, origin, std::max(kLeastCell, kCellOfDepth * (origin - camera).norm()));
  track.centroid = seen.centroid;
  tracks_.push_back(track);
  return static_cast<int>(tracks_.size()) - 1;
}

void MapTracks::see(int number, const SeenInMap& seen, const FrameTime& now) {
  TrackState& track = state(number);
  // What is left of a wall at the edge of a picture may be turned by any angle: it says nothing of the wall.
  const bool is_like = seen.plane.coefficients.head<3>().dot(track.plane.coefficients.head<3>()) > kLeastCosine;
  if (track.frames > 0 && is_like) track.join(seen.plane, seen.centroid, 2.0 * parameters_.memory_frames);
  // What is seen best counts most: a wall is none the less one when its last sliver leaves the picture.
  track.weight += seen.pixels;
  const double share = seen.pixels / std::max(1.0, track.weight);
  track.confidence += share * (seen.confidence - track.confidence);
  track.centroid += share * (seen.centroid - Eigen::Vector3d(track.centroid));
  for (const Eigen::Vector3d& place : seen.places) track.cells.add(place);
  if (track.frames == 0 || track.last_frame != now.frame) ++track.frames;
  track.last_frame = now.frame;
  track.last_time = now.seconds;
  if (track.label == 0 && track.frames >= parameters_.confirm_frames) track.label = ++last_label_;
}

// Of a young one its few frames decide.
bool MapTracks::mostSay(const PairVotes::Count& votes) const {
  const bool is_young = at(votes.pair.second).frames <= parameters_.memory_frames;
  const long needed = is_young ? parameters_.confirm_frames - 1 : parameters_.memory_frames / 2;
  return votes.for_one >= std::max(1L, needed) &&
         static_cast<double>(votes.for_one) >= kMostOfVotes * static_cast<double>(votes.all);
}

// As wide as what a single frame says: what is wrong with a sensor is wrong in every frame.
bool MapTracks::mayBeOne(const TrackState& a, const TrackState& b, const Eigen::Matrix4d& pose_error) const {
  const double memory = 2.0 * parameters_.memory_frames;
  MapPlane first = a.plane, second = b.plane;
  first.covariance *= memory;
  second.covariance = memory * second.covariance + pose_error;
  return squaredDifference(first, second, b.centroid) <= kMaxSquare;
}

void MapTracks::merge(int into, int from) {
  TrackState& kept = state(into);
  TrackState& gone = state(from);
  kept.cells.join(gone.cells);
  kept.join(gone.plane, gone.centroid, 2.0 * parameters_.memory_frames);
  gone.end = TrackEnd::Merged;
  gone.other = into;
  if (kept.label == 0) kept.label = gone.label;  // an older one that has no label yet takes over that of the other
  if (kept.label == gone.label) gone.label = 0;
}

void MapTracks::endTracks(long frame, double min_confidence) {
  for (TrackState& track : tracks_) {
    if (track.end != TrackEnd::None) continue;
    if (track.label == 0 && track.last_frame < frame) track.end = TrackEnd::NotConfirmed;
    if (track.last_frame == frame && track.frames >= parameters_.confirm_frames && track.confidence < min_confidence)
      track.end = TrackEnd::Clutter;
  }
}

}  // namespace epcc
