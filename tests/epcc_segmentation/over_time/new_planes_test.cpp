// SPDX-License-Identifier: BSD-3-Clause
// What comes into the picture of a tracker's camera: found at once where it is large, a few frames later where not.
#include <gtest/gtest.h>

#include "epcc_segmentation/plane_tracker.h"
#include "tests/epcc_segmentation/over_time/walked_room.h"

namespace epcc {
namespace {

TEST(PlaneTracker, WhatIsNewIsFoundBetweenSearches) {
  TrackerParameters rarely;
  rarely.search_frames = 1000;
  PlaneTracker tracker(rarely, Parameters(), test::kRoomSensor);
  TrackedFrame tracked;
  std::int32_t label = 0;
  for (int k = 0; k < 16; ++k) {
    test::RenderedRoom room = test::roomFrom(test::cameraAt(0), static_cast<unsigned>(k));
    const int width = room.camera.width, height = room.camera.height;
    if (k >= 8)  // something comes into the picture
      for (int row = height / 4; row < height / 2; ++row)
        for (int column = width / 4; column < width / 2; ++column)
          room.depth[static_cast<std::size_t>(row * width + column)] = 0.6f;
    ASSERT_TRUE(tracker.track(room.frame(), Isometry3(test::cameraAt(0)), k / 30.0, tracked)) << tracker.error();
    label = tracked.labels[static_cast<std::size_t>(3 * height / 8 * width + 3 * width / 8)];
  }
  EXPECT_GT(label, static_cast<std::int32_t>(test::cornerPlanes().size()));
}

TEST(PlaneTracker, LittleThatIsNewWaitsAFewFramesAndIsFoundThen) {
  TrackerParameters rarely;
  rarely.search_frames = 1000;
  PlaneTracker tracker(rarely, Parameters(), test::kRoomSensor);
  TrackedFrame tracked;
  int first = -1;
  for (int k = 0; k < 20; ++k) {
    test::RenderedRoom room = test::roomFrom(test::cameraAt(0), static_cast<unsigned>(k));
    if (k >= 8) test::addBoard(room, 40, 60, 20);  // a fiftieth of the frame
    ASSERT_TRUE(tracker.track(room.frame(), Isometry3(test::cameraAt(0)), k / 30.0, tracked)) << tracker.error();
    if (first < 0 && k >= 8 && tracked.segmentation.labels[50 * 160 + 70] > 0) first = k;
    EXPECT_TRUE(first < 0 || tracked.segmentation.labels[50 * 160 + 70] > 0) << k;
  }
  EXPECT_GE(first, 8);
  EXPECT_LE(first, 12);
}

TEST(PlaneTracker, WhatIsNewAndLargeDoesNotWait) {
  PlaneTracker tracker(TrackerParameters(), Parameters(), test::kRoomSensor);
  TrackedFrame tracked;
  for (int k = 0; k < 15; ++k) {
    test::RenderedRoom room = test::roomFrom(test::cameraAt(0), static_cast<unsigned>(k));
    if (k >= 13) test::addBoard(room, 20, 40, 80);
    ASSERT_TRUE(tracker.track(room.frame(), Isometry3(test::cameraAt(0)), k / 30.0, tracked)) << tracker.error();
    EXPECT_GT(tracked.segmentation.labels[60 * 160 + 80], 0) << k;
  }
}

}  // namespace
}  // namespace epcc
