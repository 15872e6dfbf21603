// SPDX-License-Identifier: BSD-3-Clause
// A few frames of a moving camera through the tracker, with given poses, none, or ones that make no sense.
#include <cmath>
#include <set>

#include "epcc_segmentation/plane_tracker.h"
#include "tests/fuzz/fuzz_frame.h"
#include "tests/fuzz/fuzz_settings.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/segmentation_check.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

constexpr int kMostFrames = 6;

TrackerParameters takeTracker(FuzzInput& input) {
  TrackerParameters tracker;
  tracker.confirm_frames = 1 + input.byte() % 3;
  tracker.search_frames = 1 + input.byte() % 3;
  tracker.memory_frames = 1 + input.byte() % 4;
  if (!input.oneIn(8)) return tracker;
  for (double* sigma : {&tracker.pose_offset_sigma, &tracker.pose_angle_sigma, &tracker.motion_offset_sigma,
                        &tracker.motion_angle_sigma})
    if (input.oneIn(2)) *sigma = input.anyNumber();
  tracker.confirm_frames = input.raw<std::int16_t>();
  return tracker;
}

Eigen::Isometry3d takeStep(FuzzInput& input) {
  const Eigen::Vector3d axis{input.small(), input.small(), 1.0};  // braces: from left to right
  const double angle = input.small() / 16.0, x = input.small(), y = input.small(), z = input.small();
  return Eigen::Translation3d(x / 16.0, y / 16.0, z / 16.0) * Eigen::AngleAxisd(angle, axis.normalized());
}

/// The true pose, none, or one with odd numbers in it.
std::optional<Isometry3> givenPose(const Eigen::Isometry3d& truth, FuzzInput& input) {
  const std::uint8_t kind = input.byte();
  if (kind % 4 == 1) return std::nullopt;
  Isometry3 pose = truth;
  if (kind % 4 == 2) {
    const int row = input.byte() % 3, column = input.byte() % 4;
    pose.matrix()(row, column) = input.anyNumber();
  }
  if (kind % 4 == 3) pose.translation().x() += input.small();
  return pose;
}

void checkFrame(const DepthFrame& frame, const TrackedFrame& tracked, const std::vector<PlaneTrack>& tracks) {
  checkSegmentation(frame, tracked.segmentation);
  require(tracked.label_of_plane.size() == tracked.segmentation.planes.size(), "each plane has its label");
  require(tracked.labels.size() == tracked.segmentation.labels.size(), "each pixel has its label");
  require(tracked.pose.camera_to_map.matrix().allFinite(), "a pose is finite");
  const Eigen::Matrix3d turn = tracked.pose.camera_to_map.linear();
  require((turn * turn.transpose()).isIdentity(1e-6), "a pose has a rotation");
  require(tracked.pose.covariance.allFinite() && tracked.pose_information.allFinite(), "covariances are finite");
  require(tracked.pose.covariance.diagonal().minCoeff() >= 0.0, "no variance is negative");
  std::set<std::int32_t> known{0};
  for (const PlaneTrack& track : tracks) known.insert(track.label);
  for (std::size_t i = 0; i < tracked.labels.size(); ++i) {
    require(known.count(tracked.labels[i]) != 0, "a label is that of a track");
    const std::int32_t plane = tracked.segmentation.labels[i];
    require(tracked.labels[i] == (plane == 0 ? 0 : tracked.label_of_plane[static_cast<std::size_t>(plane) - 1]),
            "a pixel has its plane's label");
  }
}

void checkTracks(const std::vector<PlaneTrack>& tracks, long frames) {
  std::int32_t last = 0;
  for (const PlaneTrack& track : tracks) {
    require(track.label > last, "tracks are in order");
    last = track.label;
    require(track.plane.coefficients.allFinite() && track.plane.covariance.allFinite(), "a track's plane is finite");
    require(std::abs(track.plane.coefficients.head<3>().norm() - 1.0) < 1e-6, "a track's normal has length 1");
    require(track.centroid.allFinite(), "a track's place is finite");
    require(0 <= track.first_frame && track.first_frame <= track.last_frame && track.last_frame < frames,
            "a track was seen in frames that were");
    require(track.frames >= 1 && track.frames <= frames, "a track's frames are counted");
    require(track.confidence >= 0.0 && track.confidence <= 1.0, "a confidence is from 0 to 1");
    require((track.end == TrackEnd::Merged) == (track.merged_into != 0), "what was merged is in another");
  }
}

bool runTracker(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  const TrackerParameters tracker_parameters = takeTracker(input);
  const Parameters parameters = takeParameters(input);
  const std::optional<SensorModel> sensor = takeSensor(input);
  PlaneTracker tracker(tracker_parameters, parameters, sensor);
  const FuzzScene scene = FuzzScene::take(input);
  const bool is_cloud = input.oneIn(4);
  FuzzFrame values = is_cloud ? FuzzFrame::take(input) : FuzzFrame::takeDepth(input);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  long taken = 0;
  TrackedFrame tracked;
  const int frames = 1 + input.byte() % kMostFrames;
  const Eigen::Isometry3d step = takeStep(input);
  for (int i = 0; i < frames; ++i) {
    const std::optional<Isometry3> given = givenPose(pose, input);
    const double time = input.oneIn(8) ? input.anyNumber() : 0.1 * i;
    values.fill(scene, pose, input);
    const DepthFrame frame = values.view();
    if (tracker.track(frame, given, time, tracked)) {
      ++taken;
      require(tracker.error().empty(), "a success says so");
      checkFrame(frame, tracked, tracker.tracks());
    } else {
      requireOneLine(tracker.error());
    }
    checkTracks(tracker.tracks(), taken);
    require(tracker.errorScale() >= 1.0 && std::isfinite(tracker.errorScale()), "an error's scale is at least 1");
    pose = pose * step;
  }
  return taken == frames;
}

std::vector<std::string> trackerSeeds() {
  std::vector<std::string> seeds;
  for (char given : {'\0', '\1'}) {
    std::string seed = std::string("\0\0\3\0", 4);                // the tracker: labels at once
    seed += std::string("\0\2\0\0", 4);                           // inverse depth, both ways
    seed += std::string("\2\2\1\x10", 4);                         // axial, 2 mm, 0.001/m, a pixel
    seed += std::string("\2\0\x08\x04\x10\xf0\x08\x18", 8);       // two planes
    seed += std::string("\0\x1f\0\x17\0\0\2\5\0\0\0\0\0\0", 14);  // depth images of 32x24
    seed += std::string("\5\1\2\1\2\3\4", 7);                     // six frames, a step
    for (int i = 0; i < kMostFrames; ++i) seed += {given, '\0'};
    seeds.push_back(seed);
  }
  return seeds;
}

}  // namespace

const FuzzTarget kTracker{runTracker, trackerSeeds};

}  // namespace epcc::fuzz
