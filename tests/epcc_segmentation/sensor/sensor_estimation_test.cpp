// SPDX-License-Identifier: BSD-3-Clause
// The sensor model measured on a frame: size and correlation of known errors, curved and cluttered scenes, units,
// scans.
#include "epcc_segmentation/sensor_estimation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "tests/epcc_segmentation/sensor/measured_rooms.h"

namespace {

using epcc::SensorModel;
using epcc::test::addBlotches;
using epcc::test::headOnWall;
using epcc::test::ratioAt;
using epcc::test::room;
using epcc::test::scaled;

// An error of kilometres is none that a model may have: the numbers are no measurement.
TEST(SensorEstimation, NumbersThatNoSensorMeasuresGiveTheGenericModel) {
  std::mt19937 generator(1);
  std::normal_distribution<float> normal;
  std::vector<float> depth(160 * 120);
  for (float& z : depth) z = 5e4f * (1.0f + 0.1f * normal(generator));
  const epcc::SensorEstimate estimate =
      epcc::estimateSensor(epcc::DepthFrame::fromDepth(depth.data(), epcc::test::testCamera()));
  EXPECT_EQ(estimate.model().validate(), "");
  EXPECT_EQ(estimate.blocks, 0U);
}

TEST(SensorEstimation, WhiteErrorIsWhiteAndItsSizeIsFound) {
  const SensorModel truth = SensorModel::axial(0.001, 0.002);
  for (auto frame : {headOnWall(), room()}) {  // white error is axial: walls of any slope show the same
    epcc::test::addNoise(frame, truth, 1);
    const auto estimate = epcc::estimateSensor(frame.frame());
    EXPECT_NEAR(estimate.effective_length, 0.4, 0.02);
    EXPECT_EQ(estimate.blotch_share, 0.0);
    EXPECT_EQ(estimate.correlation_length, 1.5);
    EXPECT_LT(estimate.correlated_share, 0.1);
    EXPECT_EQ(estimate.model().correlatedShare(), estimate.correlated_share);
    EXPECT_GT(estimate.blocks, 30u);
    for (const double z : {2.2, 2.8}) EXPECT_NEAR(ratioAt(z, estimate, truth), 1.0, 0.25) << z;
  }
}

TEST(SensorEstimation, TheLengthOfBlotchesIsFound) {
  for (const double length : {1.0, 2.0, 3.0, 4.0, 6.0, 8.0}) {
    auto frame = room();
    addBlotches(frame, SensorModel::axial(0.002, 0.002), length, 2);
    const auto estimate = epcc::estimateSensor(frame.frame());
    EXPECT_NEAR(estimate.effective_length / length, 1.0, length > 4.0 ? 0.1 : 0.05) << length;
    EXPECT_GT(estimate.blotch_share, 0.9) << length;
    EXPECT_EQ(estimate.correlated_share, 1.0) << length;
    EXPECT_NEAR(estimate.correlation_length, std::min(1.5 * estimate.effective_length + 0.4, 554.3 / 69.0), 0.01)
        << length;
  }
}

TEST(SensorEstimation, GrainAndBlotchesAreToldApart) {
  auto mixed = room();
  addBlotches(mixed, SensorModel::axial(0.003, 0.0), 5.0, 2);
  epcc::test::addNoise(mixed, SensorModel::axial(0.003, 0.0), 3);
  const auto estimate = epcc::estimateSensor(mixed.frame());
  EXPECT_NEAR(estimate.blotch_share, 0.5, 0.12);
  EXPECT_NEAR(estimate.blotch_length, 5.0, 0.6);
}

TEST(SensorEstimation, BendingIsNeitherGrainNorBlotches) {
  for (const double length : {0.0, 3.0}) {
    auto straight = room();
    if (length > 0.0)
      addBlotches(straight, SensorModel::axial(0.003, 0.0), length, 2);
    else
      epcc::test::addNoise(straight, SensorModel::axial(0.003, 0.0), 2);
    auto bent = straight;
    for (int row = 0; row < 480; ++row)  // seven times the error, 300 pixels long
      for (int column = 0; column < 640; ++column)
        bent.depth[static_cast<std::size_t>(row * 640 + column)] +=
            0.02f * std::sin(0.021f * static_cast<float>(column)) * std::cos(0.021f * static_cast<float>(row));
    const auto of_straight = epcc::estimateSensor(straight.frame()), of_bent = epcc::estimateSensor(bent.frame());
    EXPECT_NEAR(of_bent.effective_length, of_straight.effective_length, 0.1 * of_straight.effective_length) << length;
    EXPECT_GT(of_bent.correlated_share, 0.5) << length;
    EXPECT_LT(length > 0.0 ? 0.0 : of_straight.correlated_share, 0.1);
    EXPECT_NEAR(of_bent.model().sigmaZ(1.8) / of_straight.model().sigmaZ(1.8), 1.0, 0.15) << length;
  }
}

TEST(SensorEstimation, ASceneOfCylindersChangesLittle) {
  auto flat = headOnWall();
  auto curved = flat;
  for (int row = 0; row < 480; ++row)
    for (int column = 0; column < 640; ++column) {
      const float across = static_cast<float>(column % 160 - 80) / 100.0f;
      curved.depth[static_cast<std::size_t>(row * 640 + column)] -= 0.3f * std::sqrt(1.0f - across * across);
    }
  epcc::test::addNoise(flat, SensorModel::axial(0.003, 0.0), 1);
  epcc::test::addNoise(curved, SensorModel::axial(0.003, 0.0), 1);
  const auto of_flat = epcc::estimateSensor(flat.frame()), of_curved = epcc::estimateSensor(curved.frame());
  EXPECT_NEAR(of_curved.model().sigmaZ(2.0) / of_flat.model().sigmaZ(2.0), 1.0, 0.25);
  EXPECT_LT(of_curved.correlation_length, 2.0);
}

TEST(SensorEstimation, TheUnitOfLengthDoesNotMatter) {
  for (const double length : {0.0, 4.0}) {
    auto frame = room();
    if (length > 0.0)
      addBlotches(frame, SensorModel::axial(0.003, 0.002), length, 2);
    else
      epcc::test::addNoise(frame, SensorModel::axial(0.003, 0.002), 2);
    const auto metres = epcc::estimateSensor(frame.frame());
    for (const float factor : {1000.0f, 0.001f, 3.7f}) {
      const auto other = epcc::estimateSensor(scaled(frame, factor).frame());
      const auto unit = static_cast<double>(factor);
      EXPECT_NEAR(other.a / (metres.a * unit), 1.0, 0.01) << length << ", " << factor;
      EXPECT_NEAR(other.b / (metres.b / unit), 1.0, 0.01) << length << ", " << factor;
      EXPECT_NEAR(other.correlation_length, metres.correlation_length, 0.01) << length << ", " << factor;
    }
  }
}

/// What a scanner of uneven rings in the middle of a hall of 16 x 16 x 4 m measures: white noise, and each ring has an
/// offset of its own.
epcc::SensorEstimate ofHall(double error, double ring_offset) {
  constexpr int kColumns = 1024, kRings = 64;
  std::vector<float> points;
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  for (int row = 0; row < kRings; ++row) {
    const double offset = ring_offset * normal(generator);
    for (int column = 0; column < kColumns; ++column) {
      const double elevation = 0.25 - 0.008 * row - 0.0015 * (row % 3), azimuth = 0.0061 * column;
      const double x = std::cos(azimuth) * std::cos(elevation), y = std::sin(azimuth) * std::cos(elevation);
      const double z = std::sin(elevation);
      const double range =
          std::min({8.0 / std::max(std::abs(x), std::abs(y)), 2.0 / std::abs(z)}) + offset + error * normal(generator);
      for (const double coordinate : {x, y, z}) points.push_back(static_cast<float>(range * coordinate));
    }
  }
  return epcc::estimateSensor(
      epcc::DepthFrame::fromPoints(points.data(), 3, kColumns, kRings, epcc::Projection::Spherical));
}

TEST(SensorEstimation, AScanWithUnevenRingsGivesItsOwnModel) {
  const auto estimate = ofHall(0.02, 0.0);
  EXPECT_LT(estimate.effective_length, 0.6);
  EXPECT_EQ(estimate.correlation_length, 1.0);
  for (const double z : {7.0, 10.0}) EXPECT_NEAR(estimate.model().sigmaZ(z) / 0.02, 1.0, 0.35) << z;
}

TEST(SensorEstimation, OffsetsOfRingsAreNoBlotches) {
  const auto estimate = ofHall(0.005, 0.02);
  EXPECT_GT(estimate.effective_length, 0.8);  // along the ring the residuals agree
  EXPECT_EQ(estimate.correlation_length, 1.0);
  for (const double z : {7.0, 10.0}) {
    EXPECT_GT(estimate.model().sigmaZ(z), 0.02) << z;
    EXPECT_LT(estimate.model().sigmaZ(z), 0.06) << z;
  }
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
  auto blotchy = headOnWall();
  addBlotches(blotchy, truth, 6.0, 6);
  // Quadrics absorb two thirds of the variance of such blotches, and a block holds so few of them that the low quantile
  // is another third smaller: sigma would be half of the error, but for what is added back and the factor of 2.4.
  for (const double z : {2.2, 2.8}) {
    EXPECT_GT(ratioAt(z, epcc::estimateSensor(blotchy.frame()), truth), 1.2) << z;
    EXPECT_LT(ratioAt(z, epcc::estimateSensor(blotchy.frame()), truth), 2.8) << z;
  }
}

TEST(SensorEstimation, AQuantisedWallIsUncertainByHalfAStep) {
  constexpr double kStep = 0.01;
  auto frame = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(640, 480));
  std::mt19937 generator(7);
  std::normal_distribution<double> noise(0.0, 0.002);
  // Steps about as wide as a block: most residuals are far smaller than the step.
  for (int i = 0; i < 640 * 480; ++i)
    frame.depth[static_cast<std::size_t>(i)] =
        static_cast<float>(kStep * std::round((2.0 + 0.0003 * (i % 640) + noise(generator)) / kStep));
  EXPECT_NEAR(epcc::estimateSensor(frame.frame()).model().sigmaZ(2.05) / (0.5 * kStep), 1.0, 0.05);
}

TEST(SensorEstimation, WithoutAnErrorSigmaIsLessThanThePixel) {
  for (const int width : {640, 320}) {
    const auto frame = room(width, width * 3 / 4);
    const double pixel = 1.8 / frame.camera.fx;
    EXPECT_LT(epcc::estimateSensor(frame.frame()).model().sigmaZ(1.8), 0.5 * pixel / std::sqrt(12.0)) << width;
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

// Those that have no depth are no sign of clutter, be they scattered or in lines.
TEST(SensorEstimation, PixelsThatAreMissingEverywhereChangeLittle) {
  auto whole = room();
  addBlotches(whole, SensorModel::axial(0.002, 0.002), 3.0, 2);
  const auto expected = epcc::estimateSensor(whole.frame());
  std::mt19937 random(4);
  const std::vector<std::function<bool(int, int)>> patterns = {
      [&](int, int) { return random() % 10 < 3; }, [](int row, int column) { return row % 5 == 2 || column % 5 == 2; },
      [](int row, int) { return row % 4 == 3; }};
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    auto holed = whole;
    for (int row = 0; row < 480; ++row)
      for (int column = 0; column < 640; ++column)
        if (patterns[i](row, column)) holed.depth[static_cast<std::size_t>(row * 640 + column)] = 0.0f;
    const auto estimate = epcc::estimateSensor(holed.frame());
    EXPECT_GT(estimate.blocks, 0.9 * static_cast<double>(expected.blocks)) << i;
    EXPECT_NEAR(estimate.correlation_length / expected.correlation_length, 1.0, 0.1) << i;
    for (const double z : {2.2, 2.8})
      EXPECT_NEAR(estimate.model().sigmaZ(z) / expected.model().sigmaZ(z), 1.0, 0.1) << i << " at " << z;
  }
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

}  // namespace
