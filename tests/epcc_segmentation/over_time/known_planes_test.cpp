// SPDX-License-Identifier: BSD-3-Clause
// A frame of which planes are known: they are judged, what is new waits or is segmented, nonsense is not taken.
#include "epcc_segmentation/known_planes.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/support/rendered_room.h"

namespace epcc {
namespace {

const SensorModel kKnownSensor = SensorModel::axial(0.0005, 0.001, 0.0);

/// A frame and what is known of it by itself.
struct KnownFrame {
  test::RenderedRoom room = test::renderRoom(test::cornerPlanes(), test::testCamera());
  PlaneExtractor extractor{Parameters(), kKnownSensor};
  PlaneSegmentation first, again;
  KnownPlanes known;
  Continuation continuation;

  KnownFrame() {
    EXPECT_TRUE(extractor.extract(room.frame(), first));
    KnownView view;
    view.plane_of_label.push_back(0);
    for (const Plane& plane : first.planes) {
      known.planes.push_back({plane.coefficients, plane.coefficients_covariance});
      view.plane_of_label.push_back(static_cast<std::int32_t>(known.planes.size()));
    }
    view.labels = std::make_shared<std::vector<std::int32_t>>(first.labels);
    view.width = first.width;
    view.height = first.height;
    known.views.push_back(view);
    known.search = false;
    known.may_wait = true;
  }
  bool extract() { return extractor.extract(room.frame(), known, again, continuation); }
};

TEST(KnownPlanes, WhatWaitsIsTold) {
  KnownFrame frame;
  ASSERT_TRUE(frame.extract());
  EXPECT_TRUE(frame.continuation.waiting.empty());
  test::addBoard(frame.room, 40, 60, 20);
  ASSERT_TRUE(frame.extract());
  const int side = frame.continuation.waiting_side;
  EXPECT_EQ(side, 2) << "every second pixel of an image this small";
  EXPECT_NEAR(static_cast<double>(frame.continuation.waiting.size()), 400.0 / (side * side), 10.0);
  for (const std::int32_t pixel : frame.continuation.waiting) {
    EXPECT_GE(pixel / 160, 40);
    EXPECT_LT(pixel / 160, 60);
    EXPECT_GE(pixel % 160, 60);
    EXPECT_LT(pixel % 160, 80);
  }
  EXPECT_EQ(frame.again.planes.size(), frame.known.planes.size());
  for (const Plane& plane : frame.again.planes) EXPECT_EQ(plane.confidence, 1.0) << "nothing was said of it";
  frame.known.may_wait = false;
  ASSERT_TRUE(frame.extract());
  EXPECT_TRUE(frame.continuation.waiting.empty());
  EXPECT_EQ(frame.again.planes.size(), frame.known.planes.size() + 1);
}

TEST(KnownPlanes, ConfidenceIsWhatItWasWhereNothingIsJudged) {
  KnownFrame frame;
  frame.known.confidence.assign(frame.known.planes.size(), 0.625);
  ASSERT_TRUE(frame.extract());
  ASSERT_FALSE(frame.again.planes.empty());
  for (const Plane& plane : frame.again.planes) EXPECT_EQ(plane.confidence, 0.625);
}

TEST(KnownPlanes, NumbersWithoutAPlaneAreAsIfNothingWereKnown) {
  for (const int wrong : {0, 1, 2, 3}) {
    KnownFrame frame;
    KnownView& view = frame.known.views.front();
    auto labels = std::make_shared<std::vector<std::int32_t>>(*view.labels);
    if (wrong == 0) (*labels)[77] = static_cast<std::int32_t>(view.plane_of_label.size());
    if (wrong == 1) (*labels)[77] = -5;
    if (wrong == 2) view.plane_of_label.back() = static_cast<std::int32_t>(frame.known.planes.size()) + 1;
    if (wrong == 3) view.plane_of_label.back() = kNotLookedAt - 1;
    view.labels = labels;
    ASSERT_TRUE(frame.extract()) << wrong;
    EXPECT_EQ(frame.again.planes.size(), frame.first.planes.size()) << wrong;
    for (const std::int32_t known : frame.continuation.continues) EXPECT_EQ(known, -1) << wrong;
  }
}

// The pose is exact: its covariance is 0.
TEST(KnownPlanes, TwoHalvesOfAWallAreJudgedWhereNothingIsNew) {
  const test::RenderedRoom room = test::renderRoom(test::cornerPlanes(), test::testCamera());
  PlaneExtractor extractor(Parameters(), kKnownSensor);
  PlaneSegmentation first, again;
  ASSERT_TRUE(extractor.extract(room.frame(), first));
  const auto halves = static_cast<std::int32_t>(first.planes.size()) + 1;
  auto labels = std::make_shared<std::vector<std::int32_t>>(first.labels);
  for (std::size_t i = 0; i < labels->size(); ++i)
    if ((*labels)[i] == 1 && i % 160 >= 80) (*labels)[i] = halves;
  KnownPlanes known;
  KnownView view;
  view.plane_of_label.push_back(0);
  for (std::int32_t label = 1; label <= halves; ++label) {
    const Plane& plane = first.planes[label == halves ? 0 : static_cast<std::size_t>(label) - 1];
    known.planes.push_back({plane.coefficients, plane.coefficients_covariance});
    view.plane_of_label.push_back(label);
  }
  view.labels = labels;
  view.width = first.width;
  view.height = first.height;
  known.views.push_back(view);
  Continuation continuation;
  ASSERT_TRUE(extractor.extract(room.frame(), known, again, continuation));
  EXPECT_EQ(again.planes.size(), known.planes.size()) << "they are not joined in the frame";
  ASSERT_FALSE(continuation.alike.empty());
  for (const auto& pair : continuation.alike) EXPECT_EQ(pair, std::pair(0, halves - 1));
  known.search = false;
  ASSERT_TRUE(extractor.extract(room.frame(), known, again, continuation));
  EXPECT_TRUE(continuation.alike.empty());
  EXPECT_EQ(again.planes.size(), known.planes.size());
}

}  // namespace
}  // namespace epcc
