// SPDX-License-Identifier: BSD-3-Clause
// What holds of every tracked frame, whatever was seen before: random frames one after the other, with poses and
// without.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "epcc_segmentation/plane_tracker.h"
#include "tests/epcc_segmentation/properties/sound_result.h"

namespace epcc::test {
namespace {

std::string trackedProblem(const TrackedFrame& tracked, const RandomFrame& frame) {
  const std::string problem = resultProblem(tracked.segmentation, frame);
  if (!problem.empty()) return problem;
  if (tracked.label_of_plane.size() != tracked.segmentation.planes.size()) return "planes without a lasting label";
  for (const std::int32_t label : tracked.label_of_plane)
    if (label < 0) return "a lasting label is negative";
  if (tracked.labels.size() != tracked.segmentation.labels.size()) return "lasting labels are missing";
  for (std::size_t i = 0; i < tracked.labels.size(); ++i) {
    const auto own = static_cast<std::size_t>(tracked.segmentation.labels[i]);
    if (tracked.labels[i] != (own > 0 ? tracked.label_of_plane[own - 1] : 0)) return "a lasting label is another";
  }
  for (const double error : tracked.squared_error)
    if (!(error >= 0.0)) return "a squared error is " + std::to_string(error);
  const Eigen::Isometry3d pose(tracked.pose.camera_to_map);
  if (!pose.matrix().allFinite()) return "the pose is not finite";
  if ((pose.linear() * pose.linear().transpose() - Eigen::Matrix3d::Identity()).norm() > 1e-6)
    return "the pose is no rotation";
  const std::string pose_problem = covarianceProblem(tracked.pose.covariance, "the pose's covariance");
  return pose_problem.empty() ? covarianceProblem(tracked.pose_information, "pose_information") : pose_problem;
}

std::string tracksProblem(const PlaneTracker& tracker) {
  if (!(tracker.errorScale() >= 1.0)) return "the error's scale is below 1";
  std::int32_t last = 0;
  for (const PlaneTrack& track : tracker.tracks()) {
    if (track.label <= last) return "labels are not in order";
    last = track.label;
    if (std::abs(track.plane.coefficients.head<3>().norm() - 1.0) > 1e-6) return "a track's normal is no unit vector";
    const std::string problem = covarianceProblem(track.plane.covariance, "a track's covariance");
    if (!problem.empty()) return problem;
    if (track.frames < 1 || track.first_frame > track.last_frame) return "a track was seen in no frame";
  }
  return {};
}

struct Steps {
  bool has_poses = false;
  bool is_measured = false;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();

  std::optional<Isometry3> next() {
    const auto step = [](double size) { return 0.01 * size * *rc::gen::inRange(-100, 101); };
    pose = pose * Eigen::AngleAxisd(step(0.05), Eigen::Vector3d(0.3, 0.9, 0.1).normalized()) *
           Eigen::Translation3d(step(0.05), step(0.05), step(0.05));
    return has_poses ? std::optional<Isometry3>(pose) : std::nullopt;
  }
};

RC_GTEST_PROP(SoundTracks, OfOneSceneWithNewNoiseInEachFrame, ()) {
  const FrameSpec spec = *planarFrame({FrameKind::Depth, FrameKind::WholeNumbers, FrameKind::Cloud});
  Steps steps;
  steps.has_poses = *rc::gen::arbitrary<bool>();
  steps.is_measured = *rc::gen::arbitrary<bool>();
  const RandomFrame scene(spec);
  TrackerParameters parameters;
  parameters.confirm_frames = 1;
  PlaneTracker tracker(parameters, Parameters(),
                       steps.is_measured ? std::nullopt : std::optional<SensorModel>(scene.sensor()));
  TrackedFrame tracked;
  for (int k = 0; k < 4; ++k) {
    RandomFrame frame = scene;
    for (float& z : frame.depth) z *= 1.0f + 1e-4f * static_cast<float>(*rc::gen::inRange(-9, 10));
    (void)tracker.track(frame.frame(), steps.next(), 0.1 * k, tracked);
    RC_ASSERT(tracker.error() == "");
    RC_ASSERT(trackedProblem(tracked, frame) == "");
    RC_ASSERT(tracksProblem(tracker) == "");
  }
}

RC_GTEST_PROP(SoundTracks, OfFramesThatHaveNothingInCommon, ()) {
  Steps steps;
  steps.has_poses = *rc::gen::arbitrary<bool>();
  steps.is_measured = *rc::gen::arbitrary<bool>();
  TrackerParameters parameters;
  parameters.confirm_frames = 1;
  PlaneTracker tracker(parameters, Parameters(),
                       steps.is_measured ? std::nullopt : std::optional<SensorModel>(SensorModel::axial(0.002, 0.001)));
  TrackedFrame tracked;
  for (int k = 0; k < 4; ++k) {
    const RandomFrame frame(*anyFrame());
    (void)tracker.track(frame.frame(), steps.next(), 0.1 * k, tracked);
    RC_ASSERT(tracker.error() == "");
    RC_ASSERT(trackedProblem(tracked, frame) == "");
    RC_ASSERT(tracksProblem(tracker) == "");
  }
}

}  // namespace
}  // namespace epcc::test
