// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1 in vector lanes gives the bits of plain loops on every vector unit, and nearly the labels of double
// precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "tests/epcc_segmentation/metric/line_check.h"
#include "tests/support/rendered_room.h"

namespace {

using epcc::ClusteredLine;
using epcc::DepthFrame;
using epcc::MetricPipeline;
using epcc::Parameters;
using epcc::SensorModel;
using epcc::test::expectTheReference;
using epcc::test::placesOf;
using epcc::test::Reference;
using epcc::test::referenceOf;

const SensorModel kLaneSensor = SensorModel::axial(0.002, 0.002);

/// A noisy corner with holes, NaN and outliers.
epcc::test::RenderedRoom damagedRoom(unsigned seed, int width, int height) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(width, height));
  epcc::test::addNoise(room, kLaneSensor, seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  for (float& z : room.depth) {
    const float chance = uniform(generator);
    if (chance < 0.05f)
      z = 0.0f;
    else if (chance < 0.07f)
      z = std::numeric_limits<float>::quiet_NaN();
    else if (chance < 0.08f)
      z = std::numeric_limits<float>::infinity();
    else if (chance < 0.15f)
      z = 0.5f + 4.0f * uniform(generator);
  }
  return room;
}

/// Stretches of lines, outliers and gaps in every column.
epcc::test::RenderedRoom randomLines(unsigned seed, int width, int height) {
  epcc::test::RenderedRoom room{epcc::test::testCamera(width, height), {}, {}};
  room.depth.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0f);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  std::normal_distribution<float> noise(0.0f, 0.002f);
  for (int column = 0; column < width; ++column) {
    float level = 2.0f, slope = 0.0f, clutter = 0.0f;
    for (int row = 0; row < height; ++row) {
      if (uniform(generator) < 0.04f) {
        level = 0.5f + 3.0f * uniform(generator);
        slope = 0.02f * (uniform(generator) - 0.5f);
        clutter = uniform(generator) < 0.3f ? 0.5f : 0.1f * uniform(generator);
      }
      level += slope;
      float z = level + noise(generator);
      if (uniform(generator) < clutter) z = 0.3f + 4.0f * uniform(generator);
      if (uniform(generator) < 0.03f) z = 0.0f;
      room.depth[static_cast<std::size_t>(row * width + column)] = z;
    }
  }
  return room;
}

std::vector<float> pointsOf(const epcc::test::RenderedRoom& room, bool spherical) {
  std::vector<float> xyz;
  Eigen::Vector3d p;
  for (int row = 0; row < room.camera.height; ++row)
    for (int column = 0; column < room.camera.width; ++column) {
      const bool valid = room.frame().point(row, column, p);
      if (spherical) p = Eigen::Vector3d(p.z(), -p.x(), -p.y());  // forward, left, up
      for (int k = 0; k < 3; ++k)
        xyz.push_back(valid ? static_cast<float>(p(k)) : std::numeric_limits<float>::quiet_NaN());
    }
  return xyz;
}

TEST(LineLanes, DamagedRoomsOfAllShapes) {
  for (const auto& [width, height] :
       {std::pair<int, int>{160, 120}, {33, 200}, {31, 64}, {1, 300}, {300, 1}, {64, 7}}) {
    const auto room = damagedRoom(static_cast<unsigned>(width), width, height);
    expectTheReference(room.frame(), {}, kLaneSensor);
    expectTheReference(room.frame().transposed(), {}, kLaneSensor);
  }
}

TEST(LineLanes, RandomLinesWithGapsAndOutliers) {
  for (unsigned seed = 0; seed < 4; ++seed) expectTheReference(randomLines(seed, 96, 240).frame(), {}, kLaneSensor);
}

TEST(LineLanes, ConstantAndDegenerateDepth) {
  epcc::test::RenderedRoom room{epcc::test::testCamera(40, 60), std::vector<float>(2400, 1.5f), {}};
  expectTheReference(room.frame(), {}, kLaneSensor);
  for (std::size_t i = 0; i < room.depth.size(); ++i) room.depth[i] = std::ldexp(1.0f, static_cast<int>(i % 250) - 125);
  expectTheReference(room.frame(), {}, kLaneSensor);
  for (float& z : room.depth) z = 1e-30f;
  expectTheReference(room.frame(), {}, kLaneSensor);
  std::vector<float> same(3 * 2400, 1.0f);  // all points coincide
  expectTheReference(DepthFrame::fromPoints(same.data(), 3, 40, 60, epcc::Projection::Perspective), {}, kLaneSensor);
}

TEST(LineLanes, UnusualParameters) {
  const auto room = randomLines(7, 64, 240);
  for (const auto& [fit, validation, buffer] :
       {std::tuple<int, int, int>{2, 1, 3}, {3, 5, 8}, {3, 5, 9}, {5, 2, 40}, {2, 10, 200}, {20, 3, 23}}) {
    Parameters parameters;
    parameters.paper.expert.lines.fit_samples = fit;
    parameters.paper.expert.lines.validation_samples = validation;
    parameters.paper.expert.lines.buffer_samples = buffer;
    expectTheReference(room.frame(), parameters, kLaneSensor);
  }
  Parameters parameters;
  parameters.paper.expert.lines.use_sensor_noise = false;
  expectTheReference(room.frame(), parameters, kLaneSensor);
  parameters.paper.line_k_max = 5.0;
  parameters.paper.expert.lines.projection_floor = 0.7;
  expectTheReference(room.frame(), parameters, SensorModel::polynomial(0.006954, -0.003713, 0.001153, 2.0));
}

TEST(LineLanes, CloudsSphericalScansMasksAndIntegerDepth) {
  const auto room = damagedRoom(5, 100, 90);
  const auto perspective = pointsOf(room, false);
  const auto cloud = DepthFrame::fromPoints(perspective.data(), 3, 100, 90, epcc::Projection::Perspective);
  expectTheReference(cloud, {}, kLaneSensor);
  expectTheReference(cloud.transposed(), {}, kLaneSensor);
  const auto spherical = pointsOf(room, true);
  expectTheReference(DepthFrame::fromPoints(spherical.data(), 3, 100, 90, epcc::Projection::Spherical), {},
                     kLaneSensor);
  std::vector<std::uint8_t> mask(9000, 1);
  for (std::size_t i = 0; i < mask.size(); i += 7) mask[i] = 0;
  expectTheReference(cloud.masked(mask.data()), {}, kLaneSensor);
  expectTheReference(room.frame().masked(mask.data()), {}, kLaneSensor);
  std::vector<std::uint16_t> units;
  for (const float z : room.depth) units.push_back(z > 0.0f && z < 10.0f ? static_cast<std::uint16_t>(z * 4000.0f) : 0);
  epcc::DepthView<std::uint16_t> depth{units.data(), 100, 90};
  depth.scale = 0.00025;
  expectTheReference(DepthFrame::fromDepth(depth, room.camera), {}, kLaneSensor);
  expectTheReference(DepthFrame::fromDepth(depth, room.camera).transposed(), {}, kLaneSensor);
}

TEST(LineLanes, TheNumberOfThreadsChangesNothing) {
  const auto room = damagedRoom(3, 600, 120);
  std::vector<std::int32_t> expected;
  for (const int threads : {1, 2, 3, 7, 40})
    for (int run = 0; run < 5; ++run) {
      Parameters parameters;
      parameters.threads = threads;
      MetricPipeline pipeline(parameters, kLaneSensor);
      pipeline.configure(parameters, kLaneSensor);
      pipeline.clusterLines(room.frame());
      pipeline.clusterPlanes();
      std::vector<std::int32_t> labels(room.depth.size());
      EXPECT_GE(pipeline.labelPixels(room.frame(), labels), 2);
      if (expected.empty()) expected = labels;
      ASSERT_EQ(labels, expected) << threads << " threads";
    }
}

// Eq. 21: both ends are the first and the last sample, moved onto the line by less than the noise.
TEST(LineLanes, EndpointsLieOnThePrototype) {
  const auto room = damagedRoom(4, 64, 120);
  const auto xyz = pointsOf(room, false);
  const DepthFrame cloud = DepthFrame::fromPoints(xyz.data(), 3, 64, 120, epcc::Projection::Perspective);
  for (const DepthFrame& view : {room.frame(), room.frame().transposed(), cloud}) {
    MetricPipeline pipeline({}, kLaneSensor);
    pipeline.configure({}, kLaneSensor);
    pipeline.clusterLines(view);
    for (int column = 0; column < view.width(); ++column)
      for (const ClusteredLine& segment : pipeline.lineSegments()[static_cast<std::size_t>(column)]) {
        const auto section = [](const Eigen::Vector3d& p) { return Eigen::Vector2d(std::hypot(p.x(), p.z()), p.y()); };
        EXPECT_NEAR(segment.prototype.distance(section(segment.a)), 0.0, 1e-12);
        EXPECT_NEAR(segment.prototype.distance(section(segment.b)), 0.0, 1e-12);
        Eigen::Vector3d p;
        ASSERT_TRUE(view.scanPoint(segment.first, column, p));
        EXPECT_LT((segment.a - p).norm(), 0.2);
        ASSERT_TRUE(view.scanPoint(segment.last, column, p));
        EXPECT_LT((segment.b - p).norm(), 0.2);
        EXPECT_NEAR(segment.a.x() / segment.a.z(), p.x() / p.z(), 1e-5);
      }
  }
}

// A view after a larger one: nothing of the other is left.
TEST(LineLanes, MemoryOfAnotherFrameChangesNothing) {
  MetricPipeline pipeline({}, kLaneSensor);
  pipeline.configure({}, kLaneSensor);
  pipeline.clusterLines(randomLines(1, 127, 100).frame());
  const auto small = randomLines(2, 97, 80);
  pipeline.clusterLines(small.frame());
  EXPECT_EQ(placesOf(pipeline, small.frame()), referenceOf(small.frame(), {}, kLaneSensor).places(small.frame()));
}

TEST(LineLanes, DoublePrecisionGivesNearlyTheSameSegments) {
  const auto room = damagedRoom(9, 320, 240);
  const Reference<double> precise = epcc::test::preciseReferenceOf(room.frame(), kLaneSensor);
  const std::vector<int> expected = precise.places(room.frame());
  const std::vector<int> places = referenceOf(room.frame(), {}, kLaneSensor).places(room.frame());
  std::size_t different = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) different += places[i] != expected[i] ? 1 : 0;
  EXPECT_LE(different, expected.size() / 1000);
}

}  // namespace
