// SPDX-License-Identifier: BSD-3-Clause
// What a track knows of its plane and place, and what is said of pairs of them.
#include "over_time/track_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "over_time/keyframe.h"
#include "over_time/map_tracks.h"
#include "over_time/pair_votes.h"

namespace epcc {
namespace {

/// z = 2 in the map, as a camera at the origin sees it; standard deviations of two turns and of the offset at z.
MapPlane wallAt(double z, double turn, double offset) {
  MapPlane wall;
  wall.coefficients << 0.0, 0.0, -1.0, z;
  wall.covariance.setZero();
  wall.covariance(0, 0) = wall.covariance(1, 1) = turn * turn;
  wall.covariance(3, 3) = offset * offset;
  return wall;
}

TrackState trackOf(const MapPlane& plane) {
  TrackState track;
  track.plane = plane;
  track.frames = 1;
  return track;
}

const Eigen::Vector3d kPlace(0.0, 0.0, 2.0);

TEST(TrackState, TwoEquallySureFramesMeetHalfWay) {
  TrackState track = trackOf(wallAt(2.0, 0.01, 0.01));
  track.join(wallAt(2.02, 0.01, 0.01), kPlace, 1e9);
  EXPECT_NEAR(track.plane.coefficients(3), 2.01, 1e-6);
  EXPECT_NEAR(std::sqrt(track.plane.covariance(3, 3)), 0.01 / std::sqrt(2.0), 1e-4);
  EXPECT_NEAR(track.plane.coefficients.head<3>().norm(), 1.0, 1e-12);
}

TEST(TrackState, WhatIsNotSeenAnewIsNotForgotten) {
  TrackState track = trackOf(wallAt(2.0, 0.01, 0.01));
  for (int k = 0; k < 100; ++k) track.join(wallAt(2.0, 10.0, 0.01), kPlace, 10.0);  // a sliver: no word on turns
  EXPECT_LE(track.plane.covariance(0, 0), 0.01 * 0.01 * 1.0001);
  EXPECT_LT(track.plane.covariance(3, 3), 0.01 * 0.01);
}

TEST(TrackState, FollowsAPlaneThatMoves) {
  TrackState track = trackOf(wallAt(2.0, 0.01, 0.01));
  for (int k = 0; k < 100; ++k) track.join(wallAt(2.1, 0.01, 0.01), kPlace, 10.0);
  EXPECT_NEAR(track.plane.coefficients(3), 2.1, 1e-3);
  EXPECT_GT(track.plane.covariance(3, 3), 0.01 * 0.01 / 20.0) << "as much as ten frames say";
}

TEST(SquaredDifference, IsInUnitsOfBothCovariances) {
  EXPECT_NEAR(squaredDifference(wallAt(2.0, 0.01, 0.03), wallAt(2.1, 0.01, 0.04), kPlace), 4.0, 1e-9);
  MapPlane behind = wallAt(2.0, 0.01, 0.01);
  behind.coefficients *= -1.0;
  EXPECT_EQ(squaredDifference(wallAt(2.0, 0.01, 0.01), behind, kPlace), std::numeric_limits<double>::infinity());
}

TEST(SeenCells, KnowWhatIsNearAndJoin) {
  const Eigen::Vector4d plane(0.0, 0.0, -1.0, 2.0);
  SeenCells left(plane, kPlace, 0.1), right(plane, kPlace + Eigen::Vector3d(1.0, 0.0, 0.0), 0.1);
  left.add(kPlace);
  right.add(kPlace + Eigen::Vector3d(1.0, 0.0, 0.0));
  EXPECT_TRUE(left.isNear(kPlace + Eigen::Vector3d(0.09, -0.09, 0.3))) << "the distance from the plane does not count";
  EXPECT_FALSE(left.isNear(kPlace + Eigen::Vector3d(0.5, 0.0, 0.0)));
  EXPECT_FALSE(left.isNear(kPlace + Eigen::Vector3d(1.0, 0.0, 0.0)));
  left.join(right);
  EXPECT_EQ(left.count(), 2u);
  EXPECT_TRUE(left.isNear(kPlace + Eigen::Vector3d(1.0, 0.0, 0.0)));
}

TEST(PairVotes, TheLastOnesCount) {
  PairVotes votes(4);
  for (int k = 0; k < 6; ++k) votes.vote(7, 3, k < 3);
  ASSERT_EQ(votes.counts().size(), 1u);
  EXPECT_EQ(votes.counts()[0].pair, TrackPair(3, 7));
  EXPECT_EQ(votes.counts()[0].for_one, 1);
  EXPECT_EQ(votes.counts()[0].all, 4);
  votes.forget({3, 7});
  EXPECT_TRUE(votes.counts().empty());
}

TEST(MapTracks, ASliverDoesNotTurnItsWall) {
  MapTracks tracks((TrackerParameters()));
  SeenInMap seen;
  seen.plane = seen.again = wallAt(2.0, 0.01, 0.01);
  seen.places = {kPlace};
  seen.centroid = kPlace;
  seen.pixels = 1000.0;
  const int wall = tracks.birth(seen, Eigen::Vector3d::Zero(), {});
  tracks.see(wall, seen, {1, 0.1});
  const Eigen::Vector4d before(tracks.at(wall).plane.coefficients);
  const Eigen::Vector3d normal(0.95, 0.0, -std::sqrt(1.0 - 0.95 * 0.95));
  seen.plane.coefficients << normal, -normal.dot(kPlace);
  for (int frame = 2; frame < 30; ++frame) tracks.see(wall, seen, {frame, 0.1 * frame});
  EXPECT_EQ(Eigen::Vector4d(tracks.at(wall).plane.coefficients), before);
  EXPECT_EQ(tracks.at(wall).last_frame, 29);
}

TEST(Keyframe, HoldsEveryOtherPixelOfALargeFrame) {
  PlaneSegmentation segmentation;
  segmentation.width = 640;
  segmentation.height = 480;
  segmentation.labels.assign(640 * 480, 0);
  segmentation.labels[641 + 2] = 5;  // row 1, column 3
  Keyframe frame;
  frame.take(segmentation, {}, Eigen::Isometry3d::Identity(), Continuation());
  EXPECT_EQ(frame.width, 320);
  EXPECT_EQ(frame.height, 240);
  EXPECT_EQ((*frame.labels)[1], 5);
  EXPECT_EQ((*frame.labels)[0], 0);
  segmentation.width = segmentation.height = 1;
  segmentation.labels = {3};
  const Keyframe before = frame;
  frame.take(segmentation, {}, Eigen::Isometry3d::Identity(), Continuation());
  EXPECT_EQ(*frame.labels, std::vector<std::int32_t>{3});
  EXPECT_GT(before.labels->size(), 1u) << "what others hold stays";
}

TEST(Keyframe, WhatWaitsIsNotLookedAtUnlessItHasALabel) {
  PlaneSegmentation segmentation;
  segmentation.width = 640;
  segmentation.height = 480;
  segmentation.labels.assign(640 * 480, 0);
  segmentation.labels[5 * 640 + 11] = 1;  // sampled as row 2, column 5
  Continuation continuation;
  continuation.waiting = {4 * 640 + 8, 476 * 640 + 636};
  continuation.waiting_side = 4;
  Keyframe frame;
  frame.take(segmentation, {7}, Eigen::Isometry3d::Identity(), continuation);
  std::vector<std::int32_t> expected(320 * 240, 0);
  for (const int place :
       {2 * 320 + 4, 3 * 320 + 4, 3 * 320 + 5, 238 * 320 + 318, 238 * 320 + 319, 239 * 320 + 318, 239 * 320 + 319})
    expected[static_cast<std::size_t>(place)] = 2;  // one more than there are planes
  expected[2 * 320 + 5] = 1;
  EXPECT_EQ(*frame.labels, expected);
}

}  // namespace
}  // namespace epcc
