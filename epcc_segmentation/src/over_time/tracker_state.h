// SPDX-License-Identifier: BSD-3-Clause
// What a tracker knows, and the steps of a frame.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "epcc_segmentation/plane_tracker.h"
#include "over_time/keyframe.h"
#include "over_time/map_tracks.h"

namespace epcc {

struct PlaneTracker::State {
  State(const TrackerParameters& tracker_parameters, const Parameters& parameters,
        const std::optional<SensorModel>& sensor)
      : tracker(tracker_parameters), extractor(parameters, sensor), tracks(tracker_parameters) {}

  UncertainPose expectedPose(const std::optional<Eigen::Isometry3d>& given) const;
  void expect(const std::optional<Eigen::Isometry3d>& given);
  bool segment(const DepthFrame& depth, const std::optional<Isometry3>& given, TrackedFrame& result);
  bool isHardToBelieve(const Eigen::Isometry3d& given) const;
  bool goesOnInstead(const DepthFrame& depth, PlaneSegmentation& segmentation);
  KnownView knownView(const Keyframe& view);
  void takePose(TrackedFrame& result);
  void learnErrorScale(TrackedFrame& result);
  Eigen::Matrix4d poseError(const MapPlane& plane) const;
  std::vector<SeenInMap> seenPlanes(const DepthFrame& frame, const TrackedFrame& result) const;
  void assign(const std::vector<SeenInMap>& seen, double time);
  void judge();
  void label(TrackedFrame& result) const;
  void remember(const PlaneSegmentation& segmentation);
  /// Begins anew. Takes no memory.
  void forget();

  TrackerParameters tracker;
  PlaneExtractor extractor;
  MapTracks tracks;
  Status status = Status::Ok;
  std::string error;
  long frame = 0, last_search = 0, last_look = 0;
  double last_time = std::numeric_limits<double>::lowest();  // s, of the last frame
  double error_scale = 1.0;
  bool has_pose = false;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity(), motion = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d map_of_given = Eigen::Isometry3d::Identity();  // other than that after a jump of given poses
  PlaneSegmentation by_motion;
  KnownPlanes known;
  Continuation continuation;
  std::vector<int> known_tracks;              // by place in known
  std::vector<std::int32_t> number_of_track;  // in known, from 1
  Keyframe last, keyframe;
  std::vector<int> track_of_plane;  // of the frame at hand
};

}  // namespace epcc
