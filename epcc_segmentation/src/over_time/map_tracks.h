// SPDX-License-Identifier: BSD-3-Clause
// All tracks of a map: found again, born, seen, merged, ended.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/plane_tracker.h"
#include "over_time/pair_votes.h"
#include "over_time/track_state.h"

namespace epcc {

/// A plane of a frame, in the map.
struct SeenInMap {
  MapPlane plane;
  /// The same as far as a plane that was out of sight may lie beside it: the poses of both frames may be wrong.
  MapPlane again;
  std::vector<Eigen::Vector3d> places;  ///< some of its points, at least one
  Eigen::Vector3d centroid;
  double confidence = 0.0, pixels = 0.0;
};

/// Which frame it is.
struct FrameTime {
  long frame = 0;
  double seconds = 0.0;
};

class MapTracks {
 public:
  explicit MapTracks(const TrackerParameters& parameters)
      : parameters_(parameters), votes_(static_cast<std::size_t>(parameters.memory_frames)) {}

  const std::vector<TrackState>& all() const { return tracks_; }
  const TrackState& at(int track) const { return tracks_[static_cast<std::size_t>(track)]; }
  /// The track itself, or the one that it went up in.
  int last(int track) const;
  /// The same; -1 if that has ended.
  int alive(int track) const;
  /// A plane that continues none may be one that was out of sight, or a piece of one that is seen elsewhere: a track
  /// with a label, or any where none continues by itself, a place nearby and parameters that agree. -1 if there is
  /// none.
  int find(const SeenInMap& seen, bool young_too) const;
  int birth(const SeenInMap& seen, const Eigen::Vector3d& camera, const FrameTime& now);
  void see(int track, const SeenInMap& seen, const FrameTime& now);

  /// Two that touch in a frame are one surface there, or two.
  void vote(int a, int b, bool is_one) { votes_.vote(a, b, is_one); }
  /// Merges what most of the last frames say is one, as far as the planes of the map do not contradict: by
  /// `pose_error(plane)`, what two poses may be wrong by.
  template <typename PoseError>
  void mergePairs(const PoseError& pose_error);
  /// Ends what was not seen again before it had a label, and what was no plane most of the time.
  void endTracks(long frame, double min_confidence);

 private:
  TrackState& state(int track) { return tracks_[static_cast<std::size_t>(track)]; }
  bool mostSay(const PairVotes::Count& votes) const;
  bool mayBeOne(const TrackState& a, const TrackState& b, const Eigen::Matrix4d& pose_error) const;
  void merge(int into, int from);

  TrackerParameters parameters_;
  std::vector<TrackState> tracks_;
  PairVotes votes_;
  std::int32_t last_label_ = 0;
};

template <typename PoseError>
void MapTracks::mergePairs(const PoseError& pose_error) {
  for (const PairVotes::Count& votes : votes_.counts()) {
    const auto [a, b] = votes.pair;
    const bool ended = at(a).end != TrackEnd::None || at(b).end != TrackEnd::None;
    const bool merges = !ended && mostSay(votes) && mayBeOne(at(a), at(b), pose_error(at(b).plane));
    if (merges) merge(a, b);
    if (ended || merges) votes_.forget(votes.pair);
  }
}

}  // namespace epcc
