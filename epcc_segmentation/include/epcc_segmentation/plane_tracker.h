// SPDX-License-Identifier: BSD-3-Clause
// Planes over time: each has a label for life, and a place in a map.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "epcc_segmentation/export.h"
#include "epcc_segmentation/known_planes.h"
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/status.h"

namespace epcc {

/// How frames are joined to a map.
struct TrackerParameters {
  /// Standard deviation of given poses, one axis. (0, 10] m, default 0.01. Raise it if good frames are refused because
  /// the trajectory is rough; lower it for a measured trajectory that the planes are not to correct.
  double pose_offset_sigma = 0.01;
  /// The same of turns. (0, 1] rad, default 0.005.
  double pose_angle_sigma = 0.005;
  /// Standard deviation of what a camera without given poses does from frame to frame beyond going on as it did. (0,
  /// 10] m, default 0.02. Raise it for slow frame rates and hard turns; lower it for a camera on rails.
  double motion_offset_sigma = 0.02;
  /// The same of turns. (0, 1] rad, default 0.02.
  double motion_angle_sigma = 0.02;
  /// A plane gets its label when it was seen in so many frames. [1, 1000], default 3. Raise it if flicker gets labels;
  /// lower it if a new wall is to be reported at once.
  int confirm_frames = 3;
  /// What is new is segmented at once where it is much, within four frames where it is little; what was no plane in the
  /// last frame only in every so many frames. [1, 1000], default 10. Raise it for speed; lower it, to 1, if small
  /// planes at the limit of what is found are to be seen in their first frame.
  int search_frames = 10;
  /// Frames that a decision remembers: whether a track is clutter, and whether two are one. [1, 1000], default 15.
  int memory_frames = 15;

  /// What is wrong, in words; empty if nothing is.
  EPCC_CORE_EXPORT std::string validate() const;
};

/// Why a track is no more.
enum class TrackEnd {
  None,          ///< it goes on
  Merged,        ///< it turned out to be part of another, PlaneTrack::merged_into
  NotConfirmed,  ///< it was not seen again before it had a label
  Clutter,       ///< what was seen of it was no plane most of the time
};

/// "none", "merged", "not confirmed" or "clutter".
EPCC_CORE_EXPORT const char* inWords(TrackEnd end);

/// A plane of the map.
struct PlaneTrack {
  /// From 1, for life; 0 before it is confirmed.
  std::int32_t label = 0;
  MapPlane plane;                      ///< where it is, by the last frames most of all
  Vector3 centroid = Vector3::Zero();  ///< of what was seen of it, mean over its pixels, map
  long first_frame = 0;                ///< frames are counted from 0
  long last_frame = 0;                 ///< the last one that it was seen in
  double first_time = 0.0;             ///< s, as given
  double last_time = 0.0;              ///< s, of last_frame
  long frames = 0;                     ///< that it was seen in
  double confidence = 0.0;             ///< of a surface, 0 to 1, mean over its pixels
  TrackEnd end = TrackEnd::None;       ///< why it is no more
  std::int32_t merged_into = 0;        ///< label of the other
};

/// What a frame is, seen from the map.
struct TrackedFrame {
  /// The segmentation of this frame alone: its own planes, in the camera's frame.
  PlaneSegmentation segmentation;
  /// Lasting label of each of its planes, 0 if it has none yet. Two planes have the same one where the frame shows
  /// pieces of one surface, or where it is the frame that their tracks were merged in.
  std::vector<std::int32_t> label_of_plane;
  /// Number of the track of each of its planes, counted from 0 as they are born: PlaneTracker::labelOf() tells later
  /// which label those have got that have none yet.
  std::vector<int> track_of_plane;
  /// Row-major, lasting labels; 0 none.
  std::vector<std::int32_t> labels;
  /// The camera by the given or expected pose and the planes together.
  UncertainPose pose;
  Matrix6 pose_information = Matrix6::Zero();  ///< what the planes alone say of it, see openDirections()
  /// The given pose is not where the camera is among the planes of the map, which it would be had it gone on as it did:
  /// from now on given poses are taken in the map as if they had not jumped.
  bool pose_jumped = false;
  std::vector<double> squared_error;  ///< normalised, of each plane that was expected and seen (3 on average)
};

/// Directions in which the planes leave the camera's place open: unit vectors in its own frame along which
/// `pose_information` (TrackedFrame::pose_information) allows a standard deviation of more than `sigma` metres,
/// whatever the turn. None where three independent planes are seen, one in a corridor whose ends are not, two before a
/// single wall, three without any plane.
EPCC_CORE_EXPORT std::vector<Vector3> openDirections(const Matrix6& pose_information, double sigma = 0.02);

/// Follows planes through the frames of a moving camera (docs/research/over_time.md). What the planes of the map
/// explain of a frame keeps its plane, the rest is segmented anew; the pose is that which the planes and the
/// expectation agree on; a plane that was out of sight is found again by its place and parameters; two that touch and
/// turn out to be one are merged. A jump of given poses that the planes contradict is noted and taken out of all that
/// follow; along a direction that no plane determines none is seen. Frames of one camera, in their order. Known planes
/// label depth images, and clouds of a camera in its own frame, in the inverse-depth mode; of other frames each plane
/// is found again by its place, which takes given poses. Deterministic. Not for several threads at once.
class EPCC_CORE_EXPORT PlaneTracker {
 public:
  /// `parameters` and `sensor` are those of the segmentation; without a sensor it is measured on the frames (`auto`).
  /// Parameters out of range are refused by track().
  explicit PlaneTracker(const TrackerParameters& tracker = TrackerParameters(),
                        const Parameters& parameters = Parameters(),
                        const std::optional<SensorModel>& sensor = std::nullopt);
  ~PlaneTracker();
  PlaneTracker(PlaneTracker&&) noexcept;             ///< what was moved from may only be destroyed or assigned to
  PlaneTracker& operator=(PlaneTracker&&) noexcept;  ///< the same

  /// Takes the next frame, with the camera's pose, camera to map, if it is known, and its time in seconds. Without
  /// poses the first camera is the map's frame, and the camera is expected to go on as it did. Returns false, and
  /// error() says why, if the frame cannot be used, the pose is no rotation with a translation, the time is before that
  /// of the last frame, or a parameter is out of range: then it is as if the frame had not been there, and the result
  /// is of no use. So it is if memory runs out in the segmentation. If it does while the frame becomes part of the map,
  /// the map is forgotten, and labels begin anew with the next frame. Nothing is thrown.
  bool track(const DepthFrame& frame, const std::optional<Isometry3>& camera_to_map, double time, TrackedFrame& result);

  /// All tracks that had a label, in the order of their labels, ended ones included. Those out of sight go on.
  std::vector<PlaneTrack> tracks() const;
  /// The label that the track of this number has by now, that of another where it turned out to be part of one; 0 if
  /// it ended without any. Nothing while it is not confirmed, and for a number that no frame had since the map began.
  std::optional<std::int32_t> labelOf(int track) const noexcept;
  /// How the last track() ended; Ok before the first.
  Status status() const noexcept;
  /// What was wrong with the last frame, in words; empty if nothing was.
  const std::string& error() const noexcept;
  /// How long the segmentation of the last frame took, stage by stage. What known planes take is part of `lines`.
  const StageTimes& times() const noexcept;
  /// Of the last frame: as it was given, or as it is measured.
  const SensorModel& sensor() const noexcept;
  /// How many times the covariance of a frame's planes their error has been so far, at least 1. It is taken into
  /// account.
  double errorScale() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace epcc
