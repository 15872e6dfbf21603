// SPDX-License-Identifier: BSD-3-Clause
// The whole pipeline: rendered rooms, laws (transposition, scale, repetition, threads) and bad input.
#include "epcc_segmentation/plane_extractor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "epcc_segmentation/sensor_estimation.h"
#include "tests/support/rendered_room.h"

namespace {

using epcc::DepthFrame;
using epcc::Parameters;
using epcc::PlaneExtractor;
using epcc::PlaneSegmentation;
using epcc::ScanDirection;
using epcc::SensorModel;
using epcc::test::RenderedRoom;

RenderedRoom roomOfD435i(unsigned seed = 1, int width = 160, int height = 120) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(width, height));
  epcc::test::addNoise(room, *SensorModel::preset("d435i"), seed);
  return room;
}

PlaneSegmentation extractPaper(const DepthFrame& frame, const Parameters& parameters = Parameters::forPaper(),
                               const SensorModel& sensor = *SensorModel::preset("d435i")) {
  PlaneExtractor extractor(parameters, sensor);
  PlaneSegmentation result;
  EXPECT_TRUE(extractor.extract(frame, result)) << extractor.error();
  return result;
}

/// Share of the pixels of true plane `truth` that carry the label most of them have.
double coverage(const RenderedRoom& room, const PlaneSegmentation& result, std::int32_t truth) {
  std::map<std::int32_t, long> counts;
  long total = 0;
  for (std::size_t i = 0; i < room.labels.size(); ++i)
    if (room.labels[i] == truth) {
      ++total;
      if (result.labels[i] > 0) ++counts[result.labels[i]];
    }
  long most = 0;
  for (const auto& [label, count] : counts) most = std::max(most, count);
  return static_cast<double>(most) / static_cast<double>(total);
}

TEST(PlaneExtractor, ExactRoomIsItsThreePlanes) {
  const auto planes = epcc::test::cornerPlanes();
  const auto room = epcc::test::renderRoom(planes, epcc::test::testCamera());
  for (const ScanDirection scan : {ScanDirection::Columns, ScanDirection::Rows}) {
    Parameters parameters = Parameters::forPaper();
    parameters.scan = scan;
    const auto result = extractPaper(room.frame(), parameters, *SensorModel::preset("rendered"));
    ASSERT_EQ(result.planes.size(), 3u);
    for (std::int32_t truth = 1; truth <= 3; ++truth) EXPECT_GT(coverage(room, result, truth), 0.95) << truth;
    for (const auto& plane : result.planes) {
      double nearest = 1e9;
      for (const auto& truth : planes) nearest = std::min(nearest, (plane.coefficients - truth).norm());
      EXPECT_LT(nearest, 0.01);
    }
  }
}

TEST(PlaneExtractor, NoisyRoomIsItsThreePlanes) {
  int exact_count = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto room = roomOfD435i(seed, 320, 240);
    const auto result = extractPaper(room.frame());
    exact_count += result.planes.size() == 3 ? 1 : 0;
    for (std::int32_t truth = 1; truth <= 3; ++truth)
      EXPECT_GT(coverage(room, result, truth), 0.85) << "plane " << truth << " seed " << seed;
  }
  EXPECT_GE(exact_count, 8);
}

TEST(PlaneExtractor, TransposingTheImageAndSwappingTheScanTransposesTheLabels) {
  const auto room = roomOfD435i();
  const auto& camera = room.camera;
  RenderedRoom transposed;
  transposed.camera = {camera.height, camera.width, camera.fy, camera.fx, camera.cy, camera.cx};
  for (int column = 0; column < camera.width; ++column)
    for (int row = 0; row < camera.height; ++row)
      transposed.depth.push_back(room.depth[static_cast<std::size_t>(row * camera.width + column)]);
  for (const bool by_rows : {false, true}) {
    Parameters parameters = Parameters::forPaper();
    Parameters swapped = parameters;
    (by_rows ? parameters : swapped).scan = ScanDirection::Rows;
    const auto result = extractPaper(room.frame(), parameters);
    const auto result_transposed = extractPaper(transposed.frame(), swapped);
    ASSERT_GT(result.planes.size(), 0u);
    ASSERT_EQ(result.planes.size(), result_transposed.planes.size());
    for (int row = 0; row < camera.height; ++row)
      for (int column = 0; column < camera.width; ++column)
        ASSERT_EQ(result.labels[static_cast<std::size_t>(row * camera.width + column)],
                  result_transposed.labels[static_cast<std::size_t>(column * camera.height + row)]);
    const Eigen::Vector4d n = result.planes[0].coefficients;
    const Eigen::Vector4d m = result_transposed.planes[0].coefficients;
    EXPECT_LT((n - Eigen::Vector4d(m.y(), m.x(), m.z(), m.w())).norm(), 1e-9);
  }
}

TEST(PlaneExtractor, ScalingDepthNoiseAndGapTogetherKeepsTheLabels) {
  const auto room = roomOfD435i();
  Parameters parameters = Parameters::forPaper();
  const auto result = extractPaper(room.frame(), parameters);
  RenderedRoom scaled = room;
  const float s = 4.0f;
  for (float& z : scaled.depth) z *= s;
  parameters.paper.max_gap *= s;
  // sigma(s z) = s (k1 z^2 + k2 z + k3)
  const auto sensor = SensorModel::polynomial(0.006954 / s, -0.003713, 0.001153 * s, 2.0);
  const auto scaled_result = extractPaper(scaled.frame(), parameters, sensor);
  ASSERT_GT(result.planes.size(), 0u);
  EXPECT_EQ(result.labels, scaled_result.labels);
}

TEST(PlaneExtractor, TwoCallsOnOneObjectGiveTheSameBits) {
  const auto room = roomOfD435i(1);
  const auto other = roomOfD435i(2, 90, 70);
  PlaneExtractor extractor;
  PlaneSegmentation first, second;
  ASSERT_TRUE(extractor.extract(room.frame(), first));
  ASSERT_TRUE(extractor.extract(other.frame(), second));
  ASSERT_TRUE(extractor.extract(room.frame(), second));
  EXPECT_EQ(first.labels, second.labels);
  ASSERT_EQ(first.planes.size(), second.planes.size());
  for (std::size_t i = 0; i < first.planes.size(); ++i) {
    EXPECT_EQ(first.planes[i].coefficients, second.planes[i].coefficients);
    EXPECT_EQ(first.planes[i].coefficients_covariance, second.planes[i].coefficients_covariance);
  }
}

TEST(PlaneExtractor, TheNumberOfThreadsChangesNothing) {
  const auto room = roomOfD435i();
  const auto one = extractPaper(room.frame());
  for (const int threads : {2, 3, 200}) {
    Parameters parameters = Parameters::forPaper();
    parameters.threads = threads;
    EXPECT_EQ(extractPaper(room.frame(), parameters).labels, one.labels) << threads;
  }
}

TEST(PlaneExtractor, CloudOfTheSamePointsGivesTheSameLabels) {
  const auto room = roomOfD435i();
  std::vector<float> xyz;
  Eigen::Vector3d p;
  for (int row = 0; row < room.camera.height; ++row)
    for (int column = 0; column < room.camera.width; ++column) {
      ASSERT_TRUE(room.frame().point(row, column, p));
      for (int k = 0; k < 3; ++k) xyz.push_back(static_cast<float>(p(k)));
    }
  const auto cloud =
      DepthFrame::fromPoints(xyz.data(), 3, room.camera.width, room.camera.height, epcc::Projection::Perspective);
  const auto a = extractPaper(room.frame()).labels;
  const auto b = extractPaper(cloud).labels;
  long differ = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differ += a[i] != b[i] ? 1 : 0;
  EXPECT_LT(differ, static_cast<long>(a.size()) / 1000);  // single precision points
}

TEST(PlaneExtractor, MaskedPixelsAreNeverLabelled) {
  const auto room = roomOfD435i();
  std::vector<std::uint8_t> mask(room.depth.size());
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = room.labels[i] == 2 ? 0 : 1;
  const auto result = extractPaper(room.frame().masked(mask.data()));
  EXPECT_EQ(result.planes.size(), 2u);
  for (std::size_t i = 0; i < mask.size(); ++i) ASSERT_TRUE(mask[i] == 1 || result.labels[i] == 0);
}

TEST(PlaneExtractor, MinPointsDropsSmallPlanes) {
  const auto room = roomOfD435i();
  const auto all = extractPaper(room.frame());
  ASSERT_GE(all.planes.size(), 3u);
  Parameters parameters = Parameters::forPaper();
  parameters.paper.min_points = static_cast<int>(all.planes[0].pixel_count);
  const auto result = extractPaper(room.frame(), parameters);
  ASSERT_EQ(result.planes.size(), 1u);
  EXPECT_EQ(result.planes[0].pixel_count, all.planes[0].pixel_count);
}

TEST(PlaneExtractor, FramesWithoutPlanesAreNoError) {
  const auto camera = epcc::test::testCamera(32, 24);
  for (const float value :
       {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    const std::vector<float> depth(32 * 24, value);
    const auto result = extractPaper(DepthFrame::fromDepth(depth.data(), camera));
    EXPECT_TRUE(result.planes.empty());
    EXPECT_EQ(result.labels, std::vector<std::int32_t>(32 * 24, 0));
  }
}

TEST(PlaneExtractor, OneRowAndOneColumnHaveNoPlane) {
  const std::vector<float> depth(500, 2.0f);
  EXPECT_TRUE(extractPaper(DepthFrame::fromDepth(depth.data(), {500, 1, 400.0, 400.0, 250.0, 0.0})).planes.empty());
  EXPECT_TRUE(extractPaper(DepthFrame::fromDepth(depth.data(), {1, 500, 400.0, 400.0, 0.0, 250.0})).planes.empty());
}

TEST(PlaneExtractor, HugeAndTinyDepthsStayFiniteAndHugeOnesAreHoles) {
  auto room = roomOfD435i();
  auto holes = room;
  const int spoilt_columns = room.camera.width / 4;
  for (std::size_t i = 0; i < room.depth.size(); i += 7)
    if (static_cast<int>(i) % room.camera.width < spoilt_columns) {
      room.depth[i] = i % 2 == 0 ? 3e38f : 1e-38f;
      holes.depth[i] = i % 2 == 0 ? 0.0f : 1e-38f;
    }
  const auto result = extractPaper(room.frame());
  ASSERT_FALSE(result.planes.empty());
  for (const auto& plane : result.planes) {
    EXPECT_TRUE(plane.coefficients.allFinite() && plane.coefficients_covariance.allFinite());
    EXPECT_TRUE(std::isfinite(plane.rms));
  }
  EXPECT_EQ(result.labels, extractPaper(holes.frame()).labels);
}

TEST(PlaneExtractor, BadInputIsNamedAndClearsTheResult) {
  const auto room = roomOfD435i();
  PlaneSegmentation result = extractPaper(room.frame());
  ASSERT_FALSE(result.planes.empty());

  Parameters invalid;
  invalid.paper.line_k_max = -1.0;
  PlaneExtractor wrong(invalid);
  EXPECT_FALSE(wrong.extract(room.frame(), result));
  EXPECT_NE(wrong.error().find("k_max"), std::string::npos);
  EXPECT_TRUE(result.planes.empty());
  EXPECT_EQ(result.labels, std::vector<std::int32_t>(room.depth.size(), 0));

  PlaneExtractor bad_sensor(Parameters(), SensorModel::axial(-1.0, 0.0));
  EXPECT_FALSE(bad_sensor.extract(room.frame(), result));
  EXPECT_FALSE(bad_sensor.error().empty());

  EXPECT_EQ(wrong.status(), epcc::Status::InvalidParameters);

  PlaneExtractor extractor;
  EXPECT_FALSE(extractor.extract(DepthFrame::fromDepth(nullptr, room.camera), result));
  EXPECT_NE(extractor.error().find("empty"), std::string::npos);
  EXPECT_TRUE(extractor.extract(room.frame(), result));
  EXPECT_TRUE(extractor.error().empty());

  Parameters rows;
  rows.scan = ScanDirection::Rows;
  PlaneExtractor by_rows(rows);
  const std::vector<float> cloud(300, 1.0f);
  EXPECT_FALSE(by_rows.extract(DepthFrame::fromPoints(cloud.data(), 3, 10, 10, epcc::Projection::Spherical), result));
  EXPECT_NE(by_rows.error().find("spherical"), std::string::npos);
  EXPECT_EQ(by_rows.status(), epcc::Status::UnsupportedScan);
}

TEST(PlaneExtractor, MeasuresTheSensorUnlessAModelIsGiven) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(320, 240));
  const SensorModel truth = SensorModel::axial(0.004, 0.0);
  epcc::test::addNoise(room, truth, 7);
  PlaneExtractor extractor;
  PlaneSegmentation result;
  for (const epcc::Mode mode : {epcc::Mode::InverseDepth, epcc::Mode::Paper}) {
    Parameters parameters;
    parameters.mode = mode;
    extractor.setParameters(parameters);
    extractor.setSensorAuto();
    EXPECT_TRUE(extractor.measuresSensor());
    ASSERT_TRUE(extractor.extract(room.frame(), result)) << extractor.error();
    EXPECT_EQ(extractor.sensor().description(), epcc::estimateSensor(room.frame()).model().description());
    EXPECT_GT(extractor.times().sensor, 0.0);
    EXPECT_GE(result.planes.size(), 3u);
  }
  extractor.setSensor(truth);
  EXPECT_FALSE(extractor.measuresSensor());
  ASSERT_TRUE(extractor.extract(room.frame(), result));
  EXPECT_EQ(extractor.sensor().description(), truth.description());
}

TEST(PlaneExtractor, WorksAfterItsMemoryWasMovedAway) {
  const auto room = roomOfD435i();
  PlaneExtractor extractor;
  PlaneExtractor other = std::move(extractor);
  PlaneSegmentation result, expected;
  ASSERT_TRUE(other.extract(room.frame(), expected));
  extractor.setSensorAuto();
  ASSERT_TRUE(extractor.extract(room.frame(), result)) << extractor.error();
  EXPECT_EQ(result.labels, expected.labels);
}

TEST(PlaneExtractor, AbsurdSensorsAndCamerasAreRefused) {
  const auto room = roomOfD435i();
  PlaneSegmentation result;
  for (const SensorModel& absurd :
       {SensorModel::axial(1e160, 0.0), SensorModel::axial(0.001, 1e300), SensorModel::polynomial(1e300, 0.0, 0.001)}) {
    PlaneExtractor extractor(Parameters(), absurd);
    EXPECT_FALSE(extractor.extract(room.frame(), result));
    EXPECT_EQ(extractor.status(), epcc::Status::InvalidParameters);
  }
  epcc::PinholeCamera tiny_focus = room.camera, far_centre = room.camera;
  tiny_focus.fx = 1e-300;
  far_centre.cx = 1e300;
  for (const epcc::PinholeCamera& camera : {tiny_focus, far_centre}) {
    PlaneExtractor extractor;
    EXPECT_FALSE(extractor.extract(DepthFrame::fromDepth(room.depth.data(), camera), result));
    EXPECT_EQ(extractor.status(), epcc::Status::InvalidCamera);
    EXPECT_NE(camera.validate().find("1e6] pixels"), std::string::npos) << camera.validate();
  }
}

TEST(PlaneExtractor, ChangesBetweenFramesLeaveNothingBehind) {
  const auto room = roomOfD435i();
  const SensorModel fine = *SensorModel::preset("d435i");
  const SensorModel coarse = SensorModel::axial(0.05, 0.0);
  Parameters rows;
  rows.scan = ScanDirection::Rows;
  PlaneExtractor changed(Parameters(), coarse);
  PlaneSegmentation result;
  ASSERT_TRUE(changed.extract(room.frame(), result));
  for (const Parameters& parameters : {rows, Parameters::forPaper(), Parameters()}) {
    changed.setParameters(parameters);
    changed.setSensor(fine);
    ASSERT_TRUE(changed.extract(room.frame(), result));
    EXPECT_EQ(result.labels, extractPaper(room.frame(), parameters).labels);
  }
}

}  // namespace
