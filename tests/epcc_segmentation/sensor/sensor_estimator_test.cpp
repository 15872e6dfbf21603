// SPDX-License-Identifier: BSD-3-Clause
// The sensor model measured over a stream, and on frames that are pooled.
#include "epcc_segmentation/sensor_estimation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/epcc_segmentation/sensor/measured_rooms.h"

namespace {

using epcc::SensorModel;
using epcc::test::addBlotches;
using epcc::test::ratioAt;
using epcc::test::RenderedRoom;
using epcc::test::room;
using epcc::test::scaled;

TEST(SensorEstimator, SettlesOverAStreamAndOutvotesAnOddFrame) {
  const SensorModel truth = SensorModel::axial(0.002, 0.001);
  epcc::SensorEstimator estimator(5, 1);
  epcc::SensorEstimate stream;
  for (unsigned seed = 0; seed < 5; ++seed) {
    auto frame = room(320, 240);
    epcc::test::addNoise(frame, truth, seed);
    stream = estimator.update(frame.frame());
  }
  auto odd = room(320, 240);
  addBlotches(odd, SensorModel::axial(0.02, 0.0), 6.0, 9);
  const auto after = estimator.update(odd.frame());
  EXPECT_NEAR(stream.effective_length, 0.4, 0.02);
  EXPECT_NEAR(after.effective_length, 0.4, 0.02);
  EXPECT_NEAR(after.model().sigmaZ(1.8) / stream.model().sigmaZ(1.8), 1.0, 0.15);
}

TEST(SensorEstimator, OnceSettledItsEstimateIsOfRoundsOfFourFrames) {
  auto calm = room(480, 360), rough = room(480, 360);  // blocks of 32 pixels, which hold blotches of five
  epcc::test::addNoise(calm, SensorModel::axial(0.002, 0.0), 1);
  epcc::test::addNoise(rough, SensorModel::axial(0.02, 0.0), 1);
  epcc::SensorEstimator estimator(1, 4);
  EXPECT_FALSE(estimator.isSettled());
  const double settled = estimator.update(calm.frame()).model().sigmaZ(1.8);
  EXPECT_TRUE(estimator.isSettled());
  EXPECT_EQ(estimator.latest().model().sigmaZ(1.8), settled);
  for (int frame = 0; frame < 3; ++frame)
    EXPECT_EQ(estimator.update(rough.frame()).model().sigmaZ(1.8), settled) << frame;
  EXPECT_GT(estimator.update(rough.frame()).model().sigmaZ(1.8), 5.0 * settled);
  estimator.reset();
  EXPECT_EQ(estimator.update(calm.frame()).model().sigmaZ(1.8), settled);
}

TEST(SensorEstimator, ARoundOfOneFrameAfterAnotherGivesWhatTheWholeFrameGives) {
  auto frame = room();
  epcc::test::addNoise(frame, SensorModel::axial(0.003, 0.001), 1);
  epcc::SensorEstimator estimator(1, 4);
  estimator.update(room().frame());
  epcc::SensorEstimate round;
  for (int i = 0; i < 4; ++i) round = estimator.update(frame.frame());
  const auto whole = epcc::estimateSensor(frame.frame());
  EXPECT_NEAR(round.a / whole.a, 1.0, 1e-9);  // the blocks come in another order
  EXPECT_NEAR(round.b / whole.b, 1.0, 1e-9);
  EXPECT_EQ(round.correlation_length, whole.correlation_length);
  EXPECT_EQ(round.blocks, whole.blocks);
}

TEST(SensorEstimator, OnceSettledEachFrameLooksAtAQuarterOfTheBlocks) {
  auto frame = room();
  epcc::test::addNoise(frame, SensorModel::axial(0.003, 0.001), 1);
  epcc::SensorEstimator estimator;
  for (int i = 0; i < 15; ++i) {
    estimator.update(frame.frame());
    EXPECT_EQ(estimator.blocksLookedAt(), 300u) << i;  // half of them small
  }
  for (int i = 0; i < 12; ++i) {
    estimator.update(frame.frame());
    EXPECT_NEAR(static_cast<double>(estimator.blocksLookedAt()), 75.0, 1.0) << i;
  }
}

TEST(SensorEstimator, FollowsAnotherSensorAsSoonAsDocumented) {
  auto calm = room(480, 360), rough = room(480, 360);  // blocks of 32 pixels, which hold blotches of five
  epcc::test::addNoise(calm, SensorModel::axial(0.002, 0.0), 1);
  addBlotches(rough, SensorModel::axial(0.02, 0.0), 5.0, 2);
  const auto expected = epcc::estimateSensor(rough.frame());
  ASSERT_GT(expected.effective_length, 4.0);
  for (const int into_the_round : {0, 1, 3}) {
    epcc::SensorEstimator estimator;  // 15 estimates, rounds of 4 frames
    for (int i = 0; i < 15 + into_the_round; ++i) estimator.update(calm.frame());
    epcc::SensorEstimate stream;
    int frames = 0;
    do stream = estimator.update(rough.frame());
    while (++frames < 100 && stream.effective_length < 4.0);
    EXPECT_LE(frames, 35) << into_the_round;
    EXPECT_GT(frames, 24) << into_the_round << ": an odd second changes nothing";
    for (; frames < 35; ++frames) stream = estimator.update(rough.frame());
    EXPECT_NEAR(stream.model().sigmaZ(1.8) / expected.model().sigmaZ(1.8), 1.0, 0.01) << into_the_round;
    EXPECT_EQ(stream.correlation_length, expected.correlation_length) << into_the_round;
  }
}

TEST(SensorEstimator, BlocksTooLargeForTheSceneAreFollowedByARoundOfSmallOnes) {
  auto wall = room(), lattice = room();
  epcc::test::addNoise(wall, SensorModel::axial(0.002, 0.0), 1);
  epcc::test::addNoise(lattice, SensorModel::axial(0.008, 0.0), 1);
  for (int row = 0; row < 480; ++row)  // a quarter of each block of 32 but one is a hole, and of each four of 16 one
    for (int column = 0; column < 640; ++column)
      if (column / 16 % 2 == 1 && row / 16 % 2 == 1 && (row > 32 || column > 32))
        lattice.depth[static_cast<std::size_t>(row * 640 + column)] = 0.0f;
  const auto of_wall = epcc::estimateSensor(wall.frame()), of_lattice = epcc::estimateSensor(lattice.frame());
  ASSERT_GT(of_lattice.blocks, 0u);
  ASSERT_GT(of_lattice.a, 2.0 * of_wall.a);
  epcc::SensorEstimator estimator(1, 4);
  const auto afterFour = [&](const RenderedRoom& frame) {
    for (int i = 0; i < 3; ++i) estimator.update(frame.frame());
    return estimator.update(frame.frame()).a;
  };
  estimator.update(wall.frame());
  EXPECT_EQ(afterFour(lattice), of_wall.a) << "large ones find nothing";
  EXPECT_EQ(afterFour(lattice), of_lattice.a);
  EXPECT_EQ(afterFour(wall), of_wall.a) << "then large ones again";
}

TEST(SensorEstimator, ACopyGoesOnByItself) {
  auto calm = room(480, 360), rough = room(480, 360);  // blocks of 32 pixels, which hold blotches of five
  epcc::test::addNoise(calm, SensorModel::axial(0.002, 0.0), 1);
  epcc::test::addNoise(rough, SensorModel::axial(0.02, 0.0), 1);
  epcc::SensorEstimator estimator(1, 1);
  const double a = estimator.update(calm.frame()).a;
  epcc::SensorEstimator copy = estimator;
  EXPECT_GT(copy.update(rough.frame()).a, 5.0 * a);
  EXPECT_EQ(estimator.update(calm.frame()).a, a);
  copy = estimator;
  EXPECT_EQ(copy.update(calm.frame()).a, a);
}

TEST(SensorEstimator, AnotherImageSizeInTheMiddleOfARoundStartsAfresh) {
  auto large = room(), small = room(480, 360);
  epcc::test::addNoise(large, SensorModel::axial(0.002, 0.0), 1);
  epcc::test::addNoise(small, SensorModel::axial(0.02, 0.0), 1);
  epcc::SensorEstimator estimator(2, 4);
  for (int i = 0; i < 4; ++i) estimator.update(large.frame());
  const auto expected = epcc::estimateSensor(small.frame());
  const auto found = estimator.update(small.frame());
  EXPECT_EQ(found.a, expected.a);
  EXPECT_EQ(found.blocks, expected.blocks);
  EXPECT_EQ(estimator.blocksLookedAt(), 300u);
}

TEST(SensorEstimator, AnotherImageSizeStartsAfresh) {
  epcc::SensorEstimator estimator;
  auto white = room(640, 480);
  epcc::test::addNoise(white, SensorModel::axial(0.002, 0.0), 1);
  for (int i = 0; i < 4; ++i) estimator.update(white.frame());
  auto blotchy = room(480, 360);
  addBlotches(blotchy, SensorModel::axial(0.003, 0.0), 8.0, 2);
  EXPECT_GT(estimator.update(blotchy.frame()).effective_length, 6.0);
}

TEST(SensorEstimator, TheLengthIsThatOfTheMajority) {
  epcc::SensorEstimator estimator;
  auto blotchy = room(), white = room();
  addBlotches(blotchy, SensorModel::axial(0.003, 0.002), 8.0, 2);
  epcc::test::addNoise(white, SensorModel::axial(0.003, 0.002), 2);
  const double length = estimator.update(blotchy.frame()).correlation_length;
  estimator.update(blotchy.frame());
  EXPECT_EQ(estimator.update(white.frame()).correlation_length, length);
}

TEST(SensorPool, OneFrameGivesWhatItGivesAlone) {
  auto frame = room();
  addBlotches(frame, SensorModel::axial(0.003, 0.002), 4.0, 2);
  epcc::SensorPool pool;
  EXPECT_EQ(pool.measure().estimate.blocks, 0u);
  ASSERT_TRUE(pool.add(frame.frame()));
  const auto alone = epcc::estimateSensor(frame.frame());
  const auto pooled = pool.measure();
  EXPECT_EQ(pooled.estimate.a, alone.a);
  EXPECT_EQ(pooled.estimate.b, alone.b);
  EXPECT_EQ(pooled.estimate.correlation_length, alone.correlation_length);
  ASSERT_EQ(pooled.correlation.size(), 17u);
  for (std::size_t lag = 0; lag < 9; ++lag)
    EXPECT_NEAR(pooled.correlation[lag], pooled.correlation_fit[lag], 0.12) << lag;
  for (std::size_t scale = 0; scale < 3; ++scale)
    EXPECT_NEAR(pooled.kept[scale], pooled.kept_fit[scale], 0.05) << scale;
}

TEST(SensorPool, ScatteredPixelsGiveWhatTheyGiveAlone) {
  const auto everySecond = [](RenderedRoom frame, int offset) {
    for (int row = 0; row < 480; ++row)
      for (int column = 0; column < 640; ++column)
        if (row % 2 != offset || column % 2 != offset) frame.depth[static_cast<std::size_t>(row * 640 + column)] = 0.0F;
    return frame;
  };
  auto noisy = room();
  epcc::test::addNoise(noisy, SensorModel::axial(0.003, 0.002), 2);
  const auto sparse = everySecond(noisy, 0), beside = everySecond(noisy, 1);
  epcc::SensorPool pool;
  ASSERT_TRUE(pool.add(sparse.frame()));
  const auto alone = epcc::estimateSensor(sparse.frame());
  const auto pooled = pool.measure();
  ASSERT_GT(alone.blocks, 0u);
  EXPECT_EQ(pooled.estimate.blocks, alone.blocks);
  EXPECT_EQ(pooled.estimate.a, alone.a);
  EXPECT_EQ(pooled.estimate.b, alone.b);
  EXPECT_EQ(pooled.estimate.correlation_length, alone.correlation_length);
  EXPECT_FALSE(pooled.correlation.empty());
  EXPECT_FALSE(pool.add(noisy.frame())) << "of four times the pixels";
  EXPECT_TRUE(pool.add(beside.frame()));
  EXPECT_NEAR(pool.measure().estimate.model().sigmaZ(1.8) / alone.model().sigmaZ(1.8), 1.0, 0.15);
}

TEST(SensorPool, FramesOfSeveralDepthsTellFloorAndGrowthApart) {
  const SensorModel truth = SensorModel::axial(0.002, 0.004);
  epcc::SensorPool pool;
  for (const float scale : {0.3f, 1.0f, 3.0f}) {
    auto frame = scaled(room(), scale);
    epcc::test::addNoise(frame, truth, 5);
    ASSERT_TRUE(pool.add(frame.frame()));
  }
  EXPECT_EQ(pool.frames(), 3u);
  EXPECT_FALSE(pool.add(room(320, 240).frame())) << "another camera";
  const auto found = pool.measure().estimate;
  for (const double z : {0.4, 2.0, 7.0}) EXPECT_NEAR(ratioAt(z, found, truth), 1.0, 0.25) << z;
}

}  // namespace
