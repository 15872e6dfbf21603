// SPDX-License-Identifier: BSD-3-Clause
// Copies see the same points, mirrored, transposed or fewer of them.
#include "datasets/sources/frame_copies.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/tiny_frames.h"

namespace epcc::test {
namespace {

LabelledFrame original() {
  LabelledFrame frame = tinyFrame("room", 1);
  frame.camera.camera.fy = 51.0;  // unlike fx
  frame.camera.camera.cx = 37.25;
  return frame;
}

Eigen::Vector3d pointAt(const LabelledFrame& frame, int row, int column) {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  EXPECT_TRUE(frameView(frame).point(row, column, point));
  return point;
}

TEST(FrameCopies, MirroringNegatesX) {
  const LabelledFrame frame = original(), copy = copiedFrame(frame, FrameCopy::Mirrored);
  const Eigen::Vector3d p = pointAt(frame, 20, 11), q = pointAt(copy, 20, 80 - 1 - 11);
  EXPECT_LT((q - Eigen::Vector3d(-p.x(), p.y(), p.z())).norm(), 1e-12);
  EXPECT_EQ(copy.labels.at(20, 68), frame.labels.at(20, 11));
}

TEST(FrameCopies, FlippingNegatesYAndTurningBoth) {
  const LabelledFrame frame = original(), flipped = copiedFrame(frame, FrameCopy::Flipped);
  const Eigen::Vector3d p = pointAt(frame, 20, 11), q = pointAt(flipped, 60 - 1 - 20, 11);
  EXPECT_LT((q - Eigen::Vector3d(p.x(), -p.y(), p.z())).norm(), 1e-12);
  EXPECT_EQ(flipped.labels.at(39, 11), frame.labels.at(20, 11));
  const LabelledFrame turned = copiedFrame(frame, FrameCopy::Turned);
  EXPECT_EQ(turned.depth.data, copiedFrame(flipped, FrameCopy::Mirrored).depth.data);
  EXPECT_LT((pointAt(turned, 39, 68) - Eigen::Vector3d(-p.x(), -p.y(), p.z())).norm(), 1e-12);
}

TEST(FrameCopies, TransposingSwapsXAndY) {
  const LabelledFrame frame = original(), copy = copiedFrame(frame, FrameCopy::Transposed);
  EXPECT_EQ(copy.depth.width, 60);
  EXPECT_EQ(copy.depth.height, 80);
  const Eigen::Vector3d p = pointAt(frame, 20, 11), q = pointAt(copy, 11, 20);
  EXPECT_LT((q - Eigen::Vector3d(p.y(), p.x(), p.z())).norm(), 1e-12);
  EXPECT_EQ(copy.labels.at(11, 20), frame.labels.at(20, 11));
}

TEST(FrameCopies, DoneTwiceTheyAreTheOriginal) {
  const LabelledFrame frame = original();
  for (const FrameCopy copy : {FrameCopy::Mirrored, FrameCopy::Flipped, FrameCopy::Turned, FrameCopy::Transposed}) {
    const LabelledFrame twice = copiedFrame(copiedFrame(frame, copy), copy);
    EXPECT_EQ(twice.depth.data, frame.depth.data) << copyName(copy);
    EXPECT_EQ(twice.labels.data, frame.labels.data) << copyName(copy);
    EXPECT_EQ(twice.camera.camera.cx, frame.camera.camera.cx) << copyName(copy);
    EXPECT_EQ(twice.camera.camera.fy, frame.camera.camera.fy) << copyName(copy);
  }
}

TEST(FrameCopies, HalfTheResolutionKeepsPointsAndHalvesTheCorrelationLength) {
  LabelledFrame frame = original();
  frame.camera.noise = "realsense-registered";
  const LabelledFrame copy = copiedFrame(frame, FrameCopy::HalfResolution);
  EXPECT_EQ(copy.depth.width, 40);
  EXPECT_EQ(copy.depth.height, 30);
  EXPECT_LT((pointAt(copy, 10, 7) - pointAt(frame, 20, 14)).norm(), 1e-12);
  const SensorModel model = SensorModel::parse(copy.camera.noise.value()).value();
  EXPECT_EQ(model.correlationLength(), 4.75);
  EXPECT_EQ(model.sigmaZ(2.0), SensorModel::preset("realsense-registered")->sigmaZ(2.0));
}

TEST(FrameCopies, HolesLeaveTheOtherPixelsAndAllLabels) {
  const LabelledFrame frame = original(), copy = copiedFrame(frame, FrameCopy::Holes);
  EXPECT_EQ(copy.labels.data, frame.labels.data);
  std::size_t holes = 0;
  for (std::size_t i = 0; i < frame.depth.data.size(); ++i) {
    ASSERT_GT(frame.depth.data[i], 0.0F);
    if (copy.depth.data[i] == 0.0F)
      ++holes;
    else
      EXPECT_EQ(copy.depth.data[i], frame.depth.data[i]);
  }
  EXPECT_NEAR(static_cast<double>(holes) / static_cast<double>(frame.depth.data.size()), 0.25, 0.02);
  EXPECT_EQ(copiedFrame(frame, FrameCopy::Holes).depth.data, copy.depth.data);
}

TEST(FrameCopies, OddSizesKeepTheirLastPixel) {
  LabelledFrame frame = original();
  frame.camera.camera.width = 79;
  frame.camera.camera.height = 59;
  frame.depth = DepthImage(79, 59, 1.0F);
  frame.labels = LabelImage(79, 59, 3);
  const LabelledFrame copy = copiedFrame(frame, FrameCopy::HalfResolution);
  EXPECT_EQ(copy.depth.width, 40);
  EXPECT_EQ(copy.depth.height, 30);
  EXPECT_EQ(copy.labels.at(29, 39), 3);
}

TEST(FrameCopies, TruePlanesAndPoseOfTheOriginalAreLeftOut) {
  LabelledFrame frame = original();
  frame.camera.extra["pose"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  for (const char* key : {"planes", "pose"}) {
    EXPECT_TRUE(frame.camera.extra.contains(key));
    for (const FrameCopy copy : frameCopies()) EXPECT_FALSE(copiedFrame(frame, copy).camera.extra.contains(key)) << key;
  }
}

TEST(FrameCopies, ScansAreRefused) {
  LabelledFrame scan = original();
  scan.scan.assign(3 * scan.depth.data.size(), 1.0F);
  EXPECT_THROW(copiedFrame(scan, FrameCopy::Mirrored), std::invalid_argument);
}

TEST(FrameCopies, SourceIsNamedAfterOriginalAndCopy) {
  const MemorySource rooms("rooms", {original()});
  const CopiedFrames copies(rooms, FrameCopy::HalfResolution);
  EXPECT_EQ(copies.dataset(), "rooms-half");
  EXPECT_EQ(copies.size(), 1U);
  EXPECT_EQ(copies.name(0), "room");
  EXPECT_EQ(copies.read(0).depth.width, 40);
}

}  // namespace
}  // namespace epcc::test
