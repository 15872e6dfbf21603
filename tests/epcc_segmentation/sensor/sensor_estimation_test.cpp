// SPDX-License-Identifier: BSD-3-Clause
// The sensor model measured on frames: size and correlation of known errors, clutter, streams.
#include "epcc_segmentation/sensor_estimation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/rendered_room.h"

namespace {

using epcc::NoiseClass;
using epcc::SensorModel;
using epcc::test::RenderedRoom;

RenderedRoom room(int width = 640, int height = 480) {
  return epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(width, height));
}

/// Error of standard deviation sigma(z), smooth over `radius` pixels.
void addBlotches(RenderedRoom& frame, const SensorModel& sensor, double radius, unsigned seed) {
  const int width = frame.camera.width, height = frame.camera.height;
  std::mt19937 generator(seed);
  std::normal_distribution<float> normal;
  std::vector<float> field(frame.depth.size());
  for (auto& value : field) value = normal(generator);
  // A white field filtered with a Gaussian of standard deviation radius / sqrt(2) has the correlation length radius.
  const int reach = static_cast<int>(std::ceil(2.5 * radius));
  std::vector<float> kernel;
  double squares = 0.0;
  for (int k = -reach; k <= reach; ++k) {
    kernel.push_back(static_cast<float>(std::exp(-k * k / (radius * radius))));
    squares += static_cast<double>(kernel.back() * kernel.back());
  }
  const auto filter = [&](int count, int lines, int step, int line_step) {
    std::vector<float> line(static_cast<std::size_t>(count));
    for (int i = 0; i < lines; ++i) {
      for (int x = 0; x < count; ++x) {
        float sum = 0.0f;
        for (int k = -reach; k <= reach; ++k)
          sum += kernel[static_cast<std::size_t>(k + reach)] *
                 field[static_cast<std::size_t>(i * line_step + (x + k + count) % count * step)];
        line[static_cast<std::size_t>(x)] = sum;
      }
      for (int x = 0; x < count; ++x) field[static_cast<std::size_t>(i * line_step + x * step)] = line[x];
    }
  };
  filter(width, height, 1, width);
  filter(height, width, width, 1);
  for (std::size_t i = 0; i < frame.depth.size(); ++i)
    if (frame.depth[i] > 0.0f)
      frame.depth[i] += static_cast<float>(sensor.sigmaZ(static_cast<double>(frame.depth[i])) *
                                           static_cast<double>(field[i]) / squares);
}

/// The estimate aims at the sensor model's sigma: 1.7 times a low quantile of white error, 2.6 times one of blotches.
double ratioAt(double z, const epcc::SensorEstimate& estimate, const SensorModel& truth) {
  return estimate.model().sigmaZ(z) / truth.sigmaZ(z);
}

TEST(SensorEstimation, WhiteErrorIsWhiteAndItsSizeIsFound) {
  const SensorModel truth = SensorModel::axial(0.001, 0.002);
  // A wall nearly head-on: there the axial error is the orthogonal one, which the estimate describes.
  auto frame = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(640, 480));
  epcc::test::addNoise(frame, truth, 1);
  const auto estimate = epcc::estimateSensor(frame.frame());
  EXPECT_EQ(estimate.noise_class, NoiseClass::White);
  EXPECT_EQ(estimate.correlation_length, 1.0);
  EXPECT_GT(estimate.blocks, 30u);
  for (const double z : {2.2, 2.8}) {
    EXPECT_GT(ratioAt(z, estimate, truth), 1.4) << z;
    EXPECT_LT(ratioAt(z, estimate, truth), 2.2) << z;
  }
}

TEST(SensorEstimation, LongBlotchesAreLongAndShortOnesMid) {
  const SensorModel truth = SensorModel::axial(0.002, 0.002);
  auto blotchy = room();
  addBlotches(blotchy, truth, 8.0, 2);
  EXPECT_EQ(epcc::estimateSensor(blotchy.frame()).noise_class, NoiseClass::Long);
  EXPECT_NEAR(epcc::estimateSensor(blotchy.frame()).correlation_length, 8.0, 1.5);
  auto short_blotches = room();
  addBlotches(short_blotches, truth, 2.0, 2);
  EXPECT_EQ(epcc::estimateSensor(short_blotches.frame()).noise_class, NoiseClass::Mid);
  EXPECT_NEAR(epcc::estimateSensor(short_blotches.frame()).correlation_length, 2.1, 0.5);
}

TEST(SensorEstimation, ReliefOnTheWallsDoesNotLengthenShortBlotches) {
  auto flat = room();
  addBlotches(flat, SensorModel::axial(0.003, 0.0), 3.0, 2);
  auto relief = flat;
  for (int row = 0; row < 480; ++row)  // as deep as the error, on three quarters of the frame
    for (int column = 0; column < 480; ++column)
      relief.depth[static_cast<std::size_t>(row * 640 + column)] +=
          0.0035f * std::sin(0.15f * static_cast<float>(column));
  const double length = epcc::estimateSensor(flat.frame()).correlation_length;
  EXPECT_NEAR(epcc::estimateSensor(relief.frame()).correlation_length / length, 1.0, 0.12);
}

TEST(SensorEstimation, WhatTheBlocksAbsorbOfLongBlotchesIsAddedBack) {
  const SensorModel truth = SensorModel::axial(0.004, 0.006);
  auto grainy = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(640, 480));
  auto blotchy = grainy;
  epcc::test::addNoise(grainy, truth, 6);
  addBlotches(blotchy, truth, 8.0, 6);
  // The fits absorb half of the variance of such blotches; what they left alone gives a ratio of 0.84, for sigma is
  // 2.6 times the error of blotches and 1.7 times that of grain.
  for (const double z : {2.2, 2.8})
    EXPECT_GT(epcc::estimateSensor(blotchy.frame()).model().sigmaZ(z) /
                  epcc::estimateSensor(grainy.frame()).model().sigmaZ(z),
              0.95)
        << z;
}

TEST(SensorEstimation, AQuantisedWallIsAsUncertainAsItsSteps) {
  constexpr double kStep = 0.01;
  auto frame = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(640, 480));
  std::mt19937 generator(7);
  std::normal_distribution<double> noise(0.0, 0.002);
  // Steps about as wide as a block: most residuals are far smaller than the step.
  for (int i = 0; i < 640 * 480; ++i)
    frame.depth[static_cast<std::size_t>(i)] =
        static_cast<float>(kStep * std::round((2.0 + 0.0003 * (i % 640) + noise(generator)) / kStep));
  EXPECT_GE(epcc::estimateSensor(frame.frame()).model().sigmaZ(2.05), 0.95 * 2.6 * kStep / std::sqrt(12.0));
}

TEST(SensorEstimation, WithoutNoiseThePixelIsTheLimit) {
  for (const int width : {640, 320}) {
    const auto frame = room(width, width * 3 / 4);
    const auto model = epcc::estimateSensor(frame.frame()).model();
    const double pixel = 1.8 / frame.camera.fx;
    EXPECT_GT(model.sigmaZ(1.8), 0.8 * pixel / std::sqrt(12.0)) << width;
    EXPECT_LT(model.sigmaZ(1.8), 1.5 * pixel / std::sqrt(12.0)) << width;
  }
}

TEST(SensorEstimation, TwiceTheErrorIsTwiceTheSigma) {
  auto once = room(), twice = room();
  epcc::test::addNoise(once, SensorModel::axial(0.002, 0.0), 3);
  epcc::test::addNoise(twice, SensorModel::axial(0.004, 0.0), 3);
  const double a = epcc::estimateSensor(once.frame()).model().sigmaZ(1.8);
  const double b = epcc::estimateSensor(twice.frame()).model().sigmaZ(1.8);
  EXPECT_NEAR(b / a, 2.0, 0.3);
}

TEST(SensorEstimation, ClutterOnHalfOfTheFrameChangesLittle) {
  const SensorModel truth = SensorModel::axial(0.002, 0.0);
  auto clean = room(), cluttered = room();
  epcc::test::addNoise(clean, truth, 4);
  cluttered.depth = clean.depth;
  std::mt19937 generator(5);
  std::uniform_real_distribution<float> uniform(0.0f, 0.3f);
  for (int row = 0; row < 480; row += 12)
    for (int column = 0; column < 320; column += 12) {
      const float step = uniform(generator);
      for (int r = row; r < row + 12; ++r)
        for (int c = column; c < std::min(column + 12, 320); ++c)
          cluttered.depth[static_cast<std::size_t>(r * 640 + c)] -= step;
    }
  const double a = epcc::estimateSensor(clean.frame()).model().sigmaZ(1.8);
  const double b = epcc::estimateSensor(cluttered.frame()).model().sigmaZ(1.8);
  EXPECT_NEAR(b / a, 1.0, 0.35);
}

TEST(SensorEstimation, NothingToMeasureGivesTheGenericSensor) {
  const std::vector<float> nothing(64 * 48, 0.0f);
  const auto camera = epcc::test::testCamera(64, 48);
  const auto estimate = epcc::estimateSensor(epcc::DepthFrame::fromDepth(nothing.data(), camera));
  EXPECT_EQ(estimate.blocks, 0u);
  EXPECT_EQ(estimate.model().validate(), "");
  EXPECT_EQ(epcc::estimateSensor(epcc::DepthFrame::fromDepth(nullptr, camera)).blocks, 0u);
}

TEST(SensorEstimation, NoiseFreeAndTinyFramesGiveAValidModel) {
  for (const auto& frame : {room(640, 480), room(40, 30), room(16, 16), room(5, 5), room(400, 1), room(1, 400)})
    EXPECT_EQ(epcc::estimateSensor(frame.frame()).model().validate(), "");
}

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
  EXPECT_EQ(stream.noise_class, NoiseClass::White);
  EXPECT_EQ(after.noise_class, NoiseClass::White);
  EXPECT_NEAR(after.model().sigmaZ(1.8) / stream.model().sigmaZ(1.8), 1.0, 0.15);
}

TEST(SensorEstimator, OnceSettledItsEstimateIsOfRoundsOfFourFrames) {
  auto calm = room(320, 240), rough = room(320, 240);
  epcc::test::addNoise(calm, SensorModel::axial(0.002, 0.0), 1);
  epcc::test::addNoise(rough, SensorModel::axial(0.02, 0.0), 1);
  epcc::SensorEstimator estimator(1, 4);
  const double settled = estimator.update(calm.frame()).model().sigmaZ(1.8);
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
  EXPECT_EQ(round.a, whole.a);
  EXPECT_EQ(round.b, whole.b);
  EXPECT_EQ(round.noise_class, whole.noise_class);
  EXPECT_EQ(round.blocks, whole.blocks);
}

TEST(SensorEstimator, OnceSettledEachFrameLooksAtAQuarterOfTheBlocks) {
  auto frame = room();
  epcc::test::addNoise(frame, SensorModel::axial(0.003, 0.001), 1);
  epcc::SensorEstimator estimator;
  for (int i = 0; i < 15; ++i) {
    estimator.update(frame.frame());
    EXPECT_EQ(estimator.blocksLookedAt(), 120u) << i;
  }
  for (int i = 0; i < 12; ++i) {
    estimator.update(frame.frame());
    EXPECT_EQ(estimator.blocksLookedAt(), 30u) << i;
  }
}

TEST(SensorEstimator, FollowsAnotherSensorAsSoonAsDocumented) {
  auto calm = room(320, 240), rough = room(320, 240);
  epcc::test::addNoise(calm, SensorModel::axial(0.002, 0.0), 1);
  addBlotches(rough, SensorModel::axial(0.02, 0.0), 5.0, 2);
  const auto expected = epcc::estimateSensor(rough.frame());
  ASSERT_NE(expected.noise_class, NoiseClass::White);
  for (const int into_the_round : {0, 1, 3}) {
    epcc::SensorEstimator estimator;  // 15 estimates, rounds of 4 frames
    for (int i = 0; i < 15 + into_the_round; ++i) estimator.update(calm.frame());
    epcc::SensorEstimate stream;
    int frames = 0;
    do stream = estimator.update(rough.frame());
    while (++frames < 100 && stream.noise_class == NoiseClass::White);
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
  for (int row = 0; row < 480; ++row)  // a quarter of each block of 32 is a hole, and of each four of 16 one
    for (int column = 0; column < 640; ++column)
      if (column / 16 % 2 == 1 && row / 16 % 2 == 1) lattice.depth[static_cast<std::size_t>(row * 640 + column)] = 0.0f;
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
  auto calm = room(320, 240), rough = room(320, 240);
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
  EXPECT_EQ(estimator.blocksLookedAt(), 120u);
}

TEST(SensorEstimator, AnotherImageSizeStartsAfresh) {
  epcc::SensorEstimator estimator;
  auto white = room(640, 480);
  epcc::test::addNoise(white, SensorModel::axial(0.002, 0.0), 1);
  for (int i = 0; i < 4; ++i) estimator.update(white.frame());
  auto blotchy = room(480, 360);
  addBlotches(blotchy, SensorModel::axial(0.003, 0.0), 8.0, 2);
  EXPECT_EQ(estimator.update(blotchy.frame()).noise_class, NoiseClass::Long);
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

}  // namespace
