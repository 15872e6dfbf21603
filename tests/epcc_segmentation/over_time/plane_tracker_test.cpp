// SPDX-License-Identifier: BSD-3-Clause
// A camera that moves through a corner of a room: labels last, poses are found, nonsense is refused.
#include "epcc_segmentation/plane_tracker.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/epcc_segmentation/over_time/walked_room.h"

namespace epcc {
namespace {

/// Which labels each true surface had over the frames, with so many pixels.
using LabelsOfSurfaces = std::map<std::int32_t, std::set<std::int32_t>>;

void noteLabels(const test::RenderedRoom& room, const TrackedFrame& tracked, LabelsOfSurfaces& labels) {
  std::map<std::pair<std::int32_t, std::int32_t>, int> counts;
  for (std::size_t i = 0; i < room.labels.size(); ++i)
    if (tracked.labels[i] > 0) ++counts[{room.labels[i], tracked.labels[i]}];
  for (const auto& [pair, count] : counts)
    if (count > 200) labels[pair.first].insert(pair.second);
}

TEST(PlaneTracker, EachSurfaceHasOneLabelForLife) {
  PlaneTracker tracker(TrackerParameters(), Parameters(), test::kRoomSensor);
  TrackedFrame tracked;
  LabelsOfSurfaces labels;
  for (int k = 0; k < 60; ++k) {
    const test::RenderedRoom room = test::roomFrom(test::cameraAt(k), static_cast<unsigned>(k));
    ASSERT_TRUE(tracker.track(room.frame(), Isometry3(test::cameraAt(k)), k / 30.0, tracked)) << tracker.error();
    ASSERT_EQ(tracked.labels.size(), room.labels.size());
    if (k < 2) {
      EXPECT_EQ(std::count(tracked.labels.begin(), tracked.labels.end(), 0),
                static_cast<std::ptrdiff_t>(tracked.labels.size()))
          << "no label before the third frame";
    }
    noteLabels(room, tracked, labels);
  }
  ASSERT_EQ(labels.size(), test::cornerPlanes().size());
  std::set<std::int32_t> all;
  for (const auto& [surface, numbers] : labels) {
    EXPECT_EQ(numbers.size(), 1u) << surface;
    all.insert(numbers.begin(), numbers.end());
  }
  EXPECT_EQ(all.size(), labels.size());
  const std::vector<PlaneTrack> tracks = tracker.tracks();
  ASSERT_EQ(tracks.size(), labels.size());
  for (const PlaneTrack& track : tracks) {
    EXPECT_EQ(track.end, TrackEnd::None);
    EXPECT_EQ(track.last_frame, 59);
    double nearest = 1e9;  // of the room's planes, by coefficients
    for (const Eigen::Vector4d& plane : test::cornerPlanes())
      nearest = std::min(nearest, (Eigen::Vector4d(track.plane.coefficients) - plane / plane.head<3>().norm()).norm());
    EXPECT_LT(nearest, 0.005);
  }
}

/// What is open in the third frame of a camera at rest before some of the planes of the corner of a room.
std::vector<Vector3> openBefore(const std::vector<Eigen::Vector4d>& planes) {
  PlaneTracker tracker(TrackerParameters(), Parameters(), test::kRoomSensor);
  TrackedFrame tracked;
  for (unsigned k = 0; k < 3; ++k) {
    test::RenderedRoom room = test::renderRoom(planes, test::testCamera());
    test::addNoise(room, test::kRoomSensor, k);
    EXPECT_TRUE(tracker.track(room.frame(), std::nullopt, 0.1 * k, tracked)) << tracker.error();
  }
  return openDirections(tracked.pose_information);
}

TEST(PlaneTracker, SaysWhatThePlanesLeaveOpen) {
  const std::vector<Eigen::Vector4d> planes = test::cornerPlanes();
  EXPECT_TRUE(openBefore(planes).empty());
  const std::vector<Vector3> along = openBefore({planes[0], planes[1]});  // where they cross, and parallel to that
  ASSERT_EQ(along.size(), 1U);
  for (const std::size_t k : {0U, 1U}) EXPECT_LT(std::abs(along[0].dot(planes[k].head<3>().normalized())), 0.05) << k;
  const std::vector<Vector3> across = openBefore({planes[0]});
  ASSERT_EQ(across.size(), 2U);
  for (const Vector3& open : across) EXPECT_LT(std::abs(open.dot(planes[0].head<3>().normalized())), 0.05);
  EXPECT_EQ(openDirections(Matrix6::Zero()).size(), 3U);
  Matrix6 wrong = Matrix6::Identity();
  wrong(2, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(openDirections(wrong).size(), 3U);
  EXPECT_EQ(openDirections(1e4 * Matrix6::Identity(), 0.011).size(), 0U) << "1 cm each";
  EXPECT_EQ(openDirections(1e4 * Matrix6::Identity(), 0.009).size(), 3U);
}

TEST(PlaneTracker, TellsLaterWhatPlanesWithoutALabelBecame) {
  PlaneTracker tracker(TrackerParameters(), Parameters(), test::kRoomSensor);
  TrackedFrame first, tracked;
  EXPECT_FALSE(tracker.labelOf(0)) << "no frame yet";
  const test::RenderedRoom room = test::roomFrom(test::cameraAt(0), 0);
  ASSERT_TRUE(tracker.track(room.frame(), Isometry3(test::cameraAt(0)), 0.0, first)) << tracker.error();
  ASSERT_EQ(first.track_of_plane.size(), first.segmentation.planes.size());
  for (const int track : first.track_of_plane) EXPECT_FALSE(tracker.labelOf(track));
  for (int k = 1; k < 4; ++k)
    ASSERT_TRUE(
        tracker.track(test::roomFrom(test::cameraAt(k), 1U).frame(), Isometry3(test::cameraAt(k)), k / 30.0, tracked));
  std::set<std::int32_t> labels(tracked.label_of_plane.begin(), tracked.label_of_plane.end());
  for (const int track : first.track_of_plane) EXPECT_EQ(labels.erase(tracker.labelOf(track).value_or(0)), 1U);
  EXPECT_FALSE(tracker.labelOf(-1));
  EXPECT_FALSE(tracker.labelOf(1000));
}

TEST(PlaneTracker, WhatIsNotSeenAgainEndsWithoutALabel) {
  PlaneTracker tracker(TrackerParameters(), Parameters(), test::kRoomSensor);
  TrackedFrame first, next;
  const Isometry3 camera = Isometry3::Identity();
  ASSERT_TRUE(tracker.track(test::roomFrom(test::cameraAt(0), 0).frame(), camera, 0.0, first));
  ASSERT_FALSE(first.track_of_plane.empty());
  const std::vector<float> nothing(first.labels.size(), 0.0F);
  ASSERT_TRUE(tracker.track(DepthFrame::fromDepth(nothing.data(), test::testCamera()), camera, 0.1, next));
  for (const int track : first.track_of_plane) EXPECT_EQ(tracker.labelOf(track).value_or(-1), 0);
}

TEST(PlaneTracker, WithoutPosesTheCameraIsFoundByThePlanes) {
  PlaneTracker tracker(TrackerParameters(), Parameters(), test::kRoomSensor);
  TrackedFrame tracked;
  LabelsOfSurfaces labels;
  for (int k = 0; k < 60; ++k) {
    const test::RenderedRoom room = test::roomFrom(test::cameraAt(k), static_cast<unsigned>(k));
    const std::optional<Isometry3> pose = k == 0 ? std::optional<Isometry3>(test::cameraAt(0)) : std::nullopt;
    ASSERT_TRUE(tracker.track(room.frame(), pose, k / 30.0, tracked)) << tracker.error();
    const Eigen::Isometry3d error = test::cameraAt(k).inverse() * Eigen::Isometry3d(tracked.pose.camera_to_map);
    ASSERT_LT(error.translation().norm(), 0.01) << k;
    ASSERT_LT(Eigen::AngleAxisd(error.linear()).angle(), 0.005) << k;
    noteLabels(room, tracked, labels);
  }
  for (const auto& [surface, numbers] : labels) EXPECT_EQ(numbers.size(), 1u) << surface;
}

TEST(PlaneTracker, APlaneThatComesBackHasItsLabel) {
  PlaneTracker tracker(TrackerParameters(), Parameters(), test::kRoomSensor);
  TrackedFrame tracked;
  LabelsOfSurfaces labels;
  for (int k = 0; k < 40; ++k) {  // away to the side for ten frames
    Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
    const double turn = k < 10 ? 0.0 : k < 20 ? 0.12 * (k - 10) : k < 30 ? 0.12 * (30 - k) : 0.0;
    camera.linear() = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitX()).toRotationMatrix();
    const test::RenderedRoom room = test::roomFrom(camera, static_cast<unsigned>(k));
    ASSERT_TRUE(tracker.track(room.frame(), Isometry3(camera), k / 30.0, tracked)) << tracker.error();
    noteLabels(room, tracked, labels);
  }
  for (const auto& [surface, numbers] : labels) EXPECT_EQ(numbers.size(), 1u) << surface;
}

TEST(PlaneTracker, AJumpOfGivenPosesIsNotedAndTheMapStays) {
  PlaneTracker tracker(TrackerParameters(), Parameters(), test::kRoomSensor);
  TrackedFrame tracked;
  LabelsOfSurfaces labels;
  Eigen::Isometry3d jump = Eigen::Isometry3d::Identity();
  for (int k = 0; k < 60; ++k) {
    if (k == 25) jump.translation() << 0.3, -0.1, 0.4;
    const test::RenderedRoom room = test::roomFrom(test::cameraAt(k), static_cast<unsigned>(k));
    ASSERT_TRUE(tracker.track(room.frame(), Isometry3(jump * test::cameraAt(k)), k / 30.0, tracked)) << tracker.error();
    EXPECT_EQ(tracked.pose_jumped, k == 25) << k;
    const Eigen::Isometry3d error = test::cameraAt(k).inverse() * Eigen::Isometry3d(tracked.pose.camera_to_map);
    EXPECT_LT(error.translation().norm(), 0.02) << k;
    noteLabels(room, tracked, labels);
  }
  for (const auto& [surface, numbers] : labels) EXPECT_EQ(numbers.size(), 1u) << surface;
  EXPECT_EQ(tracker.tracks().size(), test::cornerPlanes().size());
}

TEST(PlaneTracker, AHastyMoveOfTheCameraIsNoJump) {
  PlaneTracker tracker(TrackerParameters(), Parameters(), test::kRoomSensor);
  TrackedFrame tracked;
  LabelsOfSurfaces labels;
  for (int k = 0; k < 40; ++k) {
    const Eigen::Isometry3d camera = test::cameraAt(k < 20 ? k : k + 30);  // as if a second of frames were lost
    const test::RenderedRoom room = test::roomFrom(camera, static_cast<unsigned>(k));
    ASSERT_TRUE(tracker.track(room.frame(), Isometry3(camera), k / 30.0, tracked)) << tracker.error();
    EXPECT_FALSE(tracked.pose_jumped) << k;
    noteLabels(room, tracked, labels);
  }
  for (const auto& [surface, numbers] : labels) EXPECT_EQ(numbers.size(), 1u) << surface;
}

TEST(PlaneTracker, TheSameFramesGiveTheSameLabels) {
  std::vector<std::int32_t> first;
  for (int run = 0; run < 2; ++run) {
    PlaneTracker tracker(TrackerParameters(), Parameters(), test::kRoomSensor);
    TrackedFrame tracked;
    for (int k = 0; k < 12; ++k)
      ASSERT_TRUE(tracker.track(test::roomFrom(test::cameraAt(k), static_cast<unsigned>(k)).frame(),
                                Isometry3(test::cameraAt(k)), k / 30.0, tracked));
    if (run == 0) first = tracked.labels;
    EXPECT_EQ(tracked.labels, first);
  }
}

TEST(PlaneTracker, NonsenseIsRefusedAndTheNextFrameIsTaken) {
  const test::RenderedRoom room = test::roomFrom(test::cameraAt(0), 1);
  TrackedFrame tracked;
  PlaneTracker tracker(TrackerParameters(), Parameters(), test::kRoomSensor);
  Isometry3 pose = Isometry3::Identity();
  pose(0, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(tracker.track(room.frame(), pose, 0.0, tracked));
  EXPECT_EQ(tracker.error(), "the pose holds a number that is not finite");
  pose = Isometry3::Identity();
  pose(0, 0) = 2.0;
  EXPECT_FALSE(tracker.track(room.frame(), pose, 0.0, tracked));
  EXPECT_EQ(tracker.error(), "the pose has no rotation");
  pose = Isometry3::Identity();
  pose(0, 3) = 7e247;
  EXPECT_FALSE(tracker.track(room.frame(), pose, 0.0, tracked));
  EXPECT_EQ(tracker.error(), "the pose is more than a million kilometres from the origin of the map");
  EXPECT_FALSE(tracker.track(room.frame(), std::nullopt, std::numeric_limits<double>::infinity(), tracked));
  EXPECT_EQ(tracker.error(), "the time is not finite");
  EXPECT_FALSE(tracker.track(DepthFrame::fromDepth(static_cast<const float*>(nullptr), test::testCamera()),
                             std::nullopt, 0.0, tracked));
  EXPECT_FALSE(tracker.error().empty());
  EXPECT_TRUE(tracker.track(room.frame(), std::nullopt, 0.0, tracked));
  EXPECT_TRUE(tracker.error().empty());
  EXPECT_FALSE(tracker.track(room.frame(), std::nullopt, -0.1, tracked));
  EXPECT_EQ(tracker.error(), "the time is before that of the last frame");
  EXPECT_TRUE(tracker.track(room.frame(), std::nullopt, 0.0, tracked)) << "who has no times gives the same each time";

  TrackerParameters wrong;
  wrong.confirm_frames = 0;
  PlaneTracker refused(wrong, Parameters(), test::kRoomSensor);
  EXPECT_FALSE(refused.track(room.frame(), std::nullopt, 0.0, tracked));
  EXPECT_EQ(refused.error(), "confirm_frames must be from 1 to 1000 frames");
  wrong = TrackerParameters();
  wrong.pose_offset_sigma = -1.0;
  EXPECT_EQ(wrong.validate(), "pose_offset_sigma must be above 0 and at most 10 m");
}

TEST(PlaneTracker, InThePaperModePlanesAreFoundByTheirPlace) {
  PlaneTracker tracker(TrackerParameters(), Parameters::forPaper(), test::kRoomSensor);
  TrackedFrame tracked;
  for (int k = 0; k < 6; ++k)
    ASSERT_TRUE(tracker.track(test::roomFrom(test::cameraAt(0), static_cast<unsigned>(k)).frame(),
                              Isometry3(test::cameraAt(0)), k / 30.0, tracked));
  EXPECT_GE(tracker.tracks().size(), test::cornerPlanes().size());
  EXPECT_GT(*std::max_element(tracked.labels.begin(), tracked.labels.end()), 0);
}

TEST(PlaneTracker, AnEmptyFrameBetweenOthersLosesNothing) {
  PlaneTracker tracker(TrackerParameters(), Parameters(), test::kRoomSensor);
  TrackedFrame tracked;
  LabelsOfSurfaces labels;
  for (int k = 0; k < 20; ++k) {
    test::RenderedRoom room = test::roomFrom(test::cameraAt(0), static_cast<unsigned>(k));
    if (k == 10) std::fill(room.depth.begin(), room.depth.end(), 0.0f);
    ASSERT_TRUE(tracker.track(room.frame(), Isometry3(test::cameraAt(0)), k / 30.0, tracked)) << tracker.error();
    noteLabels(room, tracked, labels);
  }
  for (const auto& [surface, numbers] : labels) EXPECT_EQ(numbers.size(), 1u) << surface;
}

}  // namespace
}  // namespace epcc
