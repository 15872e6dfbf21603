// SPDX-License-Identifier: BSD-3-Clause
// S0: a given model that is wrong is pulled to the frame's own error, one that is right is left alone.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/epcc_segmentation/sensor/measured_rooms.h"
#include "tests/support/rendered_room.h"

namespace {

using epcc::Parameters;
using epcc::PlaneExtractor;
using epcc::PlaneSegmentation;
using epcc::SensorModel;

const SensorModel kTruth = SensorModel::axial(0.004, 0.0, 1.0);

epcc::test::RenderedRoom measuredRoom(unsigned seed = 3) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(640, 480));
  epcc::test::addNoise(room, kTruth, seed);
  return room;
}

/// Sigma that a frame was segmented with over the true one.
double usedOverTrue(PlaneExtractor& extractor, const epcc::DepthFrame& frame) {
  PlaneSegmentation result;
  EXPECT_TRUE(extractor.extract(frame, result)) << extractor.error();
  return extractor.sensor().sigmaZ(2.0) / kTruth.sigmaZ(2.0);
}

TEST(SensorAdaptation, WrongModelsEndWithinAThirdOfTheTruth) {
  const auto room = measuredRoom();
  for (const double factor : {0.25, 0.5, 2.0, 5.0}) {
    SCOPED_TRACE(factor);
    PlaneExtractor extractor({}, kTruth.scaled(factor));
    const double used = usedOverTrue(extractor, room.frame());
    EXPECT_GT(used, 0.67);
    EXPECT_LT(used, 1.5);
    EXPECT_EQ(extractor.sensor().correlationLength(), kTruth.correlationLength());
  }
}

TEST(SensorAdaptation, TheRightModelIsLeftAsItIs) {
  const auto room = measuredRoom();
  PlaneExtractor extractor({}, kTruth);
  EXPECT_EQ(usedOverTrue(extractor, room.frame()), 1.0);
}

TEST(SensorAdaptation, TheCorrelatedShareIsThatOfTheFrameIfThatIsLess) {
  const auto shareUsed = [](const epcc::test::RenderedRoom& room, double given) {
    PlaneExtractor extractor({}, kTruth.withCorrelatedShare(given));
    PlaneSegmentation result;
    EXPECT_TRUE(extractor.extract(room.frame(), result));
    return extractor.sensor().correlatedShare();
  };
  EXPECT_LT(shareUsed(measuredRoom(), 1.0), 0.1);
  auto blotchy = epcc::test::room();
  epcc::test::addBlotches(blotchy, kTruth, 2.0, 5);
  EXPECT_EQ(shareUsed(blotchy, 1.0), 1.0);
  EXPECT_EQ(shareUsed(blotchy, 0.2), 0.2);
}

TEST(SensorAdaptation, PolynomialsKeepTheirShape) {
  const auto room = measuredRoom();
  const SensorModel given = SensorModel::polynomial(0.001, 0.0, 0.030, 1.0);
  PlaneExtractor extractor({}, given);
  PlaneSegmentation result;
  ASSERT_TRUE(extractor.extract(room.frame(), result));
  const auto before = given.coefficients(), after = extractor.sensor().coefficients();
  EXPECT_LT(after[2], 0.5 * before[2]);
  EXPECT_NEAR(after[0] / after[2], before[0] / before[2], 1e-12);
}

TEST(SensorAdaptation, FacesThatAModelTwiceTooWideMergesAreApartAgain) {
  // Two walls 10 mm apart, the error 1 mm, the model 6 mm.
  auto room = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(640, 480));
  for (std::size_t i = 0; i < room.depth.size(); ++i)
    if (i % 640 > 320) room.depth[i] += 0.010f;
  epcc::test::addNoise(room, SensorModel::axial(0.001, 0.0, 1.0), 4);
  Parameters as_given;
  as_given.inverse_depth.adapt_sensor = false;
  for (const auto& [parameters, planes] : {std::pair(Parameters(), 2u), std::pair(as_given, 1u)}) {
    PlaneExtractor extractor(parameters, SensorModel::axial(0.008, 0.0, 1.0));
    PlaneSegmentation result;
    ASSERT_TRUE(extractor.extract(room.frame(), result));
    EXPECT_EQ(result.planes.size(), planes);
  }
}

TEST(SensorAdaptation, OffAndInPaperModeTheModelIsTheGivenOne) {
  const auto room = measuredRoom();
  Parameters off;
  off.inverse_depth.adapt_sensor = false;
  for (const Parameters& parameters : {off, Parameters::forPaper()}) {
    PlaneExtractor extractor(parameters, kTruth.scaled(3.0));
    EXPECT_DOUBLE_EQ(usedOverTrue(extractor, room.frame()), 3.0);
  }
}

TEST(SensorAdaptation, AFrameThatShowsNothingLeavesTheModel) {
  const std::vector<float> depth(640 * 480, 0.0f);
  PlaneExtractor extractor({}, kTruth.scaled(3.0));
  EXPECT_DOUBLE_EQ(usedOverTrue(extractor, epcc::DepthFrame::fromDepth(depth.data(), epcc::test::testCamera(640, 480))),
                   3.0);
}

TEST(SensorAdaptation, OverAStreamTheModelSettlesAndStartsAfreshWithANewOne) {
  PlaneExtractor extractor({}, kTruth.scaled(4.0));
  double used = 0.0;
  for (unsigned frame = 0; frame < 40; ++frame) used = usedOverTrue(extractor, measuredRoom(frame).frame());
  EXPECT_GT(used, 0.67);
  EXPECT_LT(used, 1.5);
  extractor.setSensor(kTruth);
  EXPECT_EQ(usedOverTrue(extractor, measuredRoom().frame()), 1.0);
}

double lengthUsed(const epcc::test::RenderedRoom& room, double given_length) {
  PlaneExtractor extractor({}, kTruth.withCorrelationLength(given_length));
  PlaneSegmentation result;
  EXPECT_TRUE(extractor.extract(room.frame(), result)) << extractor.error();
  return extractor.sensor().correlationLength();
}

/// Every second pixel of every second row.
epcc::test::RenderedRoom half(const epcc::test::RenderedRoom& room) {
  epcc::test::RenderedRoom result{room.camera, {}, {}};
  epcc::PinholeCamera& camera = result.camera;
  camera = {camera.width / 2, camera.height / 2, camera.fx / 2, camera.fy / 2, camera.cx / 2, camera.cy / 2};
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column)
      result.depth.push_back(room.depth[static_cast<std::size_t>(2 * row * room.camera.width + 2 * column)]);
  return result;
}

TEST(SensorAdaptation, TheLengthOfALargerImageIsPulledToThatOfItsCopy) {
  auto room = epcc::test::room();
  epcc::test::addBlotches(room, kTruth, 4.0, 5);
  EXPECT_EQ(lengthUsed(room, 6.4), 6.4) << "what a model of such blotches has";
  const double used = lengthUsed(half(room), 6.4);
  EXPECT_GT(used, 2.8);
  EXPECT_LT(used, 4.5);
}

TEST(SensorAdaptation, ALengthThatIsTooShortIsPulledToTheBlotchesSeen) {
  auto room = epcc::test::room();
  epcc::test::addBlotches(room, kTruth, 4.0, 5);
  EXPECT_GT(lengthUsed(room, 1.0), 4.5);
  EXPECT_LT(lengthUsed(room, 1.0), 7.0);
}

TEST(SensorAdaptation, WhereGrainIsSeenAShortLengthStays) {
  for (const double length : {0.0, 0.4, 1.0, 1.5}) EXPECT_EQ(lengthUsed(measuredRoom(), length), length);
  EXPECT_LT(lengthUsed(measuredRoom(), 6.0), 2.0);
}

}  // namespace
