// SPDX-License-Identifier: BSD-3-Clause
// Least-squares planes: exact data, order, and a covariance that predicts the scatter of repeated fits.
#include "epcc_segmentation/plane_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "tests/support/rendered_room.h"
#include "tests/support/vector_units.h"

namespace {

using epcc::DepthFrame;
using epcc::PlaneSegmentation;
using epcc::SensorModel;

PlaneSegmentation fitted(const epcc::test::RenderedRoom& room, const SensorModel& sensor, int planes) {
  PlaneSegmentation segmentation;
  segmentation.width = room.camera.width;
  segmentation.height = room.camera.height;
  segmentation.labels = room.labels;
  epcc::fitPlanes(room.frame(), sensor, planes, segmentation);
  return segmentation;
}

TEST(PlaneFit, ExactRoomGivesItsPlanesSortedBySize) {
  const auto planes = epcc::test::cornerPlanes();
  const auto room = epcc::test::renderRoom(planes, epcc::test::testCamera());
  const auto result = fitted(room, SensorModel::preset("rendered").value(), 3);
  ASSERT_EQ(result.planes.size(), 3u);
  for (std::size_t i = 0; i < result.labels.size(); ++i) {
    const auto& plane = result.planes[static_cast<std::size_t>(result.labels[i] - 1)];
    const auto& truth = planes[static_cast<std::size_t>(room.labels[i] - 1)];
    ASSERT_LT((plane.coefficients - truth).norm(), 1e-5);
    ASSERT_GT(plane.coefficients(3), 0.0);
    ASSERT_NEAR(plane.coefficients.head<3>().norm(), 1.0, 1e-12);
    ASSERT_LT(plane.rms, 1e-6);
  }
  for (std::size_t k = 1; k < 3; ++k) EXPECT_GE(result.planes[k - 1].pixel_count, result.planes[k].pixel_count);
}

TEST(PlaneFit, LabelsWithoutPixelsDisappear) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  for (auto& label : room.labels) label *= 3;  // ids 3, 6, 9 of nine
  const auto result = fitted(room, *SensorModel::preset("d435i"), 9);
  EXPECT_EQ(result.planes.size(), 3u);
  EXPECT_EQ(*std::max_element(result.labels.begin(), result.labels.end()), 3);
}

TEST(PlaneFit, MemoryIsForThePixelsHoweverLargeTheLabelsAre) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  const auto usual = fitted(room, *SensorModel::preset("d435i"), 3);
  constexpr std::int32_t kLargest = std::numeric_limits<std::int32_t>::max();
  for (auto& label : room.labels) label = kLargest - 3 + label;
  const auto result = fitted(room, *SensorModel::preset("d435i"), kLargest);
  EXPECT_EQ(result.labels, usual.labels);
  ASSERT_EQ(result.planes.size(), usual.planes.size());
  for (std::size_t i = 0; i < usual.planes.size(); ++i)
    EXPECT_EQ(result.planes[i].coefficients, usual.planes[i].coefficients);
}

TEST(PlaneFit, OtherLabelsThanThePlanesCountAsNone) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  const auto usual = fitted(room, *SensorModel::preset("d435i"), 3);
  for (std::size_t i = 0; i < room.labels.size(); ++i)
    if (usual.labels[i] == 3) room.labels[i] = i % 2 == 0 ? 4 : -7;
  room.labels.front() = std::numeric_limits<std::int32_t>::max();
  room.labels.back() = std::numeric_limits<std::int32_t>::min();
  const auto frame = room.frame();
  for (const auto& view : {frame, frame.transposed()}) {
    PlaneSegmentation segmentation;
    segmentation.labels = room.labels;
    EXPECT_TRUE(epcc::fitPlanes(view, *SensorModel::preset("d435i"), 3, segmentation));
    ASSERT_EQ(segmentation.planes.size(), 2u);
    for (std::size_t i = 1; i + 1 < room.labels.size(); ++i)
      ASSERT_EQ(segmentation.labels[i], usual.labels[i] == 3 ? 0 : usual.labels[i]) << i;
    EXPECT_EQ(segmentation.labels.front(), 0);
    EXPECT_EQ(segmentation.labels.back(), 0);
  }
}

TEST(PlaneFit, OtherLabelsCountAsNoneWhereNothingIsMeasured) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  const auto usual = fitted(room, *SensorModel::preset("d435i"), 3);
  room.labels = usual.labels;  // in order: nothing else changes them
  for (const std::size_t pixel : {std::size_t{3}, std::size_t{17}, room.labels.size() - 1}) {
    const float depth = room.depth[pixel];
    const std::int32_t label = room.labels[pixel];
    room.depth[pixel] = 0.0f;
    room.labels[pixel] = pixel == 17 ? -1 : 4;
    epcc::test::onEveryVectorUnit(
        [&] { EXPECT_EQ(fitted(room, *SensorModel::preset("d435i"), 3).labels[pixel], 0) << pixel; });
    room.depth[pixel] = depth;
    room.labels[pixel] = label;
  }
}

TEST(PlaneFit, RefusesLabelsOfAnotherSizeAndANegativeCount) {
  const auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  const auto refused = [&](std::size_t labels, int plane_count) {
    PlaneSegmentation segmentation;
    segmentation.planes.resize(2);
    segmentation.labels.assign(labels, 1);
    const bool done = epcc::fitPlanes(room.frame(), *SensorModel::preset("d435i"), plane_count, segmentation);
    return !done && segmentation.planes.empty() && segmentation.labels == std::vector<std::int32_t>(labels, 1);
  };
  EXPECT_TRUE(refused(room.labels.size() - 1, 1));
  EXPECT_TRUE(refused(room.labels.size() + 1, 1));
  EXPECT_TRUE(refused(0, 1));
  EXPECT_TRUE(refused(room.labels.size(), -1));
}

TEST(PlaneFit, CentroidAndPointCovarianceAreThoseOfThePoints) {
  const auto room = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(40, 30));
  const auto result = fitted(room, *SensorModel::preset("d435i"), 1);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), p;
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  const auto each = [&](const auto& visit) {
    for (int row = 0; row < 30; ++row)
      for (int column = 0; column < 40; ++column)
        if (room.frame().point(row, column, p)) visit();
  };
  each([&] { mean += p / 1200.0; });
  each([&] { squares += (p - mean) * (p - mean).transpose() / 1200.0; });
  EXPECT_EQ(result.planes[0].pixel_count, 1200u);
  EXPECT_LT((result.planes[0].centroid - mean).norm(), 1e-9);
  EXPECT_LT((result.planes[0].points_covariance - squares).norm(), 1e-9);
}

// A depth image is summed row by row with shared rays, a transposed view point by point: the same planes.
TEST(PlaneFit, RowsOfADepthImageGiveWhatItsPointsGive) {
  const SensorModel sensor = SensorModel::axial(0.002, 0.003);
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  epcc::test::addNoise(room, sensor, 3);
  for (std::size_t i = 0; i < room.depth.size(); ++i) {
    if (i % 11 == 0) room.depth[i] = 0.0f;  // holes, also where a run of a label starts
    if (i % 50 < 9) room.labels[i] = 0;     // several runs of a label in a row
  }
  const auto rows = fitted(room, sensor, 3);
  PlaneSegmentation points;
  points.labels = room.labels;
  epcc::fitPlanes(room.frame().transposed(), sensor, 3, points);
  ASSERT_EQ(rows.planes.size(), 3u);
  ASSERT_EQ(points.planes.size(), 3u);
  EXPECT_EQ(rows.labels, points.labels);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& a = rows.planes[k];
    const auto& b = points.planes[k];
    EXPECT_EQ(a.pixel_count, b.pixel_count);
    EXPECT_LT((a.coefficients - b.coefficients).norm(), 1e-9);
    EXPECT_LT((a.centroid - b.centroid).norm(), 1e-9);
    EXPECT_LT((a.points_covariance - b.points_covariance).norm(), 1e-9);
    EXPECT_NEAR(a.rms, b.rms, 1e-9);
    EXPECT_LT((a.coefficients_covariance - b.coefficients_covariance).norm(), 1e-6 * b.coefficients_covariance.norm());
  }
}

TEST(PlaneFit, CovariancePredictsTheScatterOfRepeatedFits) {
  const SensorModel white = SensorModel::axial(0.005, 0.0, 0.1);  // one pixel a sample
  const int runs = 200;
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  Eigen::Vector4d squares = Eigen::Vector4d::Zero();
  Eigen::Vector4d predicted = Eigen::Vector4d::Zero();
  for (int run = 0; run < runs; ++run) {
    auto room = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(40, 30));
    epcc::test::addNoise(room, white, static_cast<unsigned>(run));
    const auto plane = fitted(room, white, 1).planes[0];
    sum += plane.coefficients;
    squares += plane.coefficients.cwiseAbs2();
    predicted += plane.coefficients_covariance.diagonal() / runs;
  }
  const Eigen::Vector4d variance = (squares - sum.cwiseAbs2() / runs) / (runs - 1);
  for (const int k : {0, 1, 3}) EXPECT_NEAR(variance(k) / predicted(k), 1.0, 0.3) << k;
}

TEST(PlaneFit, Equation28ProjectsOnThePlane) {
  epcc::Plane plane;
  plane.coefficients << 0.0, 0.6, -0.8, 2.0;
  const Eigen::Vector3d p(0.3, -0.2, 2.0);
  const Eigen::Vector3d q = plane.project(p);
  EXPECT_NEAR(plane.signedDistance(q), 0.0, 1e-12);
  EXPECT_NEAR((p - q).cross(plane.coefficients.head<3>()).norm(), 0.0, 1e-12);
}

}  // namespace
