// SPDX-License-Identifier: BSD-3-Clause
// Clouds of scanners, what no sensor has seen so, and the finder of a stream of clouds.
#include "epcc_segmentation/cloud_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "epcc_segmentation/plane_fit.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "tests/epcc_segmentation/geometry/found_geometry.h"

namespace {

using epcc::CloudGeometry;
using epcc::CloudOptions;
using epcc::DepthFrame;
using epcc::PlaneExtractor;
using epcc::PlaneSegmentation;
using epcc::Projection;
using epcc::SensorModel;
using epcc::Status;
using epcc::test::bodyAxes;
using epcc::test::expectPlanesOnTheirPoints;
using epcc::test::expectTruth;
using epcc::test::Found;
using epcc::test::geometryOf;
using epcc::test::kNoTurn;
using epcc::test::kOrigin;
using epcc::test::kShift;
using epcc::test::kTurn;
using epcc::test::moved;
using epcc::test::PosedCloud;
using epcc::test::posedRoom;
using epcc::test::segment;

// ---- scanners ----

/// Rings from both ends in turn.
PosedCloud shuffledRings(const PosedCloud& cloud) {
  return epcc::test::reordered(cloud, cloud.width, cloud.height, [&](int row, int column) {
    return static_cast<std::size_t>((row % 2 == 0 ? row / 2 : cloud.height - 1 - row / 2) * cloud.width + column);
  });
}

TEST(ScannerGeometry, APlaneAcrossTheSeamIsOne) {
  for (const double first : {0.0, M_PI / 2, 0.7}) {
    const PosedCloud cloud = epcc::test::scannerCloud(360, 32, first);
    const Found found = segment(cloud);
    ASSERT_EQ(found.error, "") << first;
    EXPECT_TRUE(found.geometry.is_plain);
    EXPECT_TRUE(found.geometry.grid.closes_round);
    expectTruth(cloud, found.result, 4);
  }
}

TEST(ScannerGeometry, LessThanATurnDoesNotClose) {
  const PosedCloud cloud = epcc::test::scannerCloud(360, 32, 0.4, 1.95 * M_PI);
  EXPECT_EQ(geometryOf(cloud).projection, Projection::Spherical);
  EXPECT_FALSE(geometryOf(cloud).grid.closes_round);
}

// Its columns are the cones of the rings. With a geometry it read beyond the cloud.
TEST(ScannerGeometry, ATransposedViewIsRefused) {
  for (const PosedCloud& cloud :
       {epcc::test::scannerCloud(360, 32), moved(epcc::test::scannerCloud(90, 32), kTurn, kShift)}) {
    const auto geometry = geometryOf(cloud);
    ASSERT_EQ(geometry.status, Status::Ok);
    ASSERT_EQ(geometry.projection, Projection::Spherical);
    PlaneExtractor extractor(epcc::Parameters(), SensorModel::parse("0.03,0,1"));
    epcc::PlaneSegmentation result;
    const auto frame = DepthFrame::fromPoints(cloud.xyz.data(), 3, cloud.width, cloud.height, geometry);
    EXPECT_TRUE(extractor.extract(frame, result)) << extractor.error();
    EXPECT_FALSE(extractor.extract(frame.transposed(), result));
    EXPECT_EQ(extractor.status(), Status::UnsupportedScan);
    EXPECT_TRUE(result.planes.empty());
  }
}

TEST(ScannerGeometry, AnyFrameAndOrder) {
  Eigen::Matrix3d y_up, x_up;
  y_up << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  x_up << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  // Tilted so that forward stays forward: which azimuth is zero is the finder's choice.
  const Eigen::Matrix3d tilt = Eigen::AngleAxisd(25.0 * M_PI / 180.0, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const std::vector<std::pair<Eigen::Matrix3d, Eigen::Vector3d>> poses = {
      {kNoTurn, kOrigin}, {y_up, kOrigin}, {x_up, kOrigin}, {tilt, kOrigin}, {kNoTurn, kShift}, {tilt, kShift}};
  const PosedCloud plain = epcc::test::scannerCloud(360, 32);
  const int width = plain.width, height = plain.height;
  const auto staggered = epcc::test::reordered(plain, width, height, [&](int row, int column) {
    return static_cast<std::size_t>(row * width + (column + row % 4 * 6) % width);
  });
  for (const PosedCloud& order : {plain, epcc::test::rowsAndColumnsExchanged(plain), staggered, shuffledRings(plain),
                                  epcc::test::rowsAndColumnsExchanged(staggered)})
    for (const auto& [axes, origin] : poses) {
      SCOPED_TRACE(testing::Message() << order.width << "x" << order.height << "\n"
                                      << axes << "\n"
                                      << origin.transpose());
      const PosedCloud cloud = moved(order, axes, origin);
      const Found found = segment(cloud);
      ASSERT_EQ(found.error, "");
      EXPECT_EQ(found.geometry.projection, Projection::Spherical);
      EXPECT_LT((found.geometry.pose.origin - origin).norm(), 0.01);
      expectTruth(cloud, found.result, 4);
      expectPlanesOnTheirPoints(cloud, found, 1.0, origin);
    }
}

TEST(ScannerGeometry, ShiftedRingsOfLessThanATurnLoseNothing) {
  const PosedCloud plain = epcc::test::scannerCloud(200, 32, 0.9, 1.8);
  const auto cloud = epcc::test::reordered(
      plain, 212, 32, [](int row, int column) { return static_cast<std::size_t>(row * 212 + column + row % 3 * 6); });
  const Found found = segment(cloud);
  ASSERT_EQ(found.error, "");
  EXPECT_EQ(found.geometry.grid.margin, 12);
  expectTruth(cloud, found.result, 2);
}

TEST(ScannerGeometry, RowsCutOrJoinedAreNoScan) {
  for (const double turn : {2.0 * M_PI, 1.8}) {
    const PosedCloud plain = epcc::test::scannerCloud(360, 32, 0.3, turn);
    for (const PosedCloud& scan : {plain, epcc::test::rowsAndColumnsExchanged(plain), moved(plain, kTurn, kShift)})
      for (const int k : {2, 4}) {
        PosedCloud cut = scan, joined = scan;
        cut.width /= k;
        cut.height *= k;
        joined.width *= k;
        joined.height /= k;
        EXPECT_EQ(geometryOf(cut).status, Status::UnknownGeometry) << cut.width << ", turn " << turn;
        EXPECT_EQ(geometryOf(joined).status, Status::UnknownGeometry) << joined.width << ", turn " << turn;
      }
  }
}

TEST(ScannerGeometry, RingsInAnyOrderAreNotTakenForJoinedRows) {
  const PosedCloud plain = epcc::test::scannerCloud(360, 32);
  const auto two_banks = epcc::test::reordered(plain, 360, 32, [](int row, int column) {  // 0 2 4 ... 1 3 5 ...
    return static_cast<std::size_t>((row / 2 + row % 2 * 16) * 360 + column);
  });
  EXPECT_EQ(geometryOf(two_banks).status, Status::Ok);
  EXPECT_EQ(geometryOf(epcc::test::rowsAndColumnsExchanged(two_banks)).status, Status::Ok);
}

TEST(ScannerGeometry, TheViewpointIsTriedAndNeedNotBeRight) {
  const PosedCloud cloud = moved(epcc::test::scannerCloud(360, 32), kTurn, kShift);
  for (const double error : {0.0, 3.0}) {
    CloudOptions options;
    options.viewpoint = epcc::SensorPose();
    options.viewpoint->axes = kTurn;
    options.viewpoint->origin = kShift + error * Eigen::Vector3d::UnitX();
    EXPECT_LT((geometryOf(cloud, options).pose.origin - kShift).norm(), 0.01) << error;
  }
}

TEST(ScannerGeometry, SegmentsAreInTheCloudsFrameAndOrder) {
  const PosedCloud plain = epcc::test::scannerCloud(360, 32);
  const auto upside_down = epcc::test::reordered(
      plain, 360, 32, [](int row, int column) { return static_cast<std::size_t>((31 - row) * 360 + column); });
  for (const PosedCloud& order : {plain, upside_down, shuffledRings(plain)})
    for (const bool exchanged : {false, true}) {
      const PosedCloud cloud = moved(exchanged ? epcc::test::rowsAndColumnsExchanged(order) : order, kTurn, kShift);
      const CloudGeometry geometry = geometryOf(cloud);
      epcc::Parameters parameters;
      parameters.line_segments = true;
      PlaneExtractor extractor(parameters, SensorModel::parse("0.008,0,1"));
      PlaneSegmentation result;
      ASSERT_TRUE(
          extractor.extract(DepthFrame::fromPoints(cloud.xyz.data(), 3, cloud.width, cloud.height, geometry), result));
      ASSERT_GT(result.segments.size(), 300u);
      for (const epcc::LineSegment& segment : result.segments) {
        EXPECT_EQ(segment.scan, exchanged ? epcc::ScanDirection::Rows : epcc::ScanDirection::Columns);
        EXPECT_LT(segment.first, segment.last);
        const auto point = [&](int position) -> Eigen::Vector3d {
          const auto pixel = static_cast<std::size_t>(segment.row(position) * cloud.width + segment.column(position));
          return Eigen::Map<const Eigen::Vector3f>(&cloud.xyz[3 * pixel]).cast<double>();
        };
        EXPECT_LT((segment.start - point(segment.first)).norm(), 0.05);
        EXPECT_LT((segment.end - point(segment.last)).norm(), 0.05);
      }
    }
}

// ---- both ----

TEST(CloudGeometry, WhatNoSensorSeesIsRefusedInOneLine) {
  std::mt19937 generator(3);
  std::normal_distribution<float> normal;
  PosedCloud noise{64, 48, {}, std::vector<std::int32_t>(64 * 48, 0)};
  for (std::size_t i = 0; i < 3 * noise.size(); ++i) noise.xyz.push_back(normal(generator));
  PosedCloud heights = noise;  // seen from everywhere
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column) {
      float* p = &heights.xyz[static_cast<std::size_t>(3 * (64 * row + column))];
      p[0] = 0.02f * static_cast<float>(column);
      p[1] = 0.02f * static_cast<float>(row);
      p[2] = 0.5f * std::sin(0.2f * static_cast<float>(column)) * std::cos(0.15f * static_cast<float>(row));
    }
  for (const PosedCloud& cloud : {noise, heights}) {
    const Found found = segment(cloud);
    EXPECT_EQ(found.geometry.status, Status::UnknownGeometry);
    EXPECT_NE(found.error, "");
    EXPECT_EQ(found.error.find('\n'), std::string::npos);
    EXPECT_TRUE(found.result.planes.empty());
  }
}

TEST(CloudGeometry, OnlyTheNamedKindIsFound) {
  CloudOptions scanner, camera;
  scanner.sensor = CloudOptions::Sensor::Scanner;
  camera.sensor = CloudOptions::Sensor::Camera;
  EXPECT_EQ(geometryOf(epcc::test::scannerCloud(360, 32), camera).status, Status::UnknownGeometry);
  EXPECT_EQ(geometryOf(epcc::test::scannerCloud(360, 32), scanner).status, Status::Ok);
  EXPECT_EQ(geometryOf(posedRoom(), camera).projection, Projection::Perspective);
}

TEST(CloudGeometry, TooFewPointsCountAsACamera) {
  const std::vector<float> nothing(300, NAN);
  const CloudGeometry geometry = epcc::findGeometry(nothing.data(), 3, 10, 10);
  EXPECT_EQ(geometry.status, Status::Ok);
  EXPECT_TRUE(geometry.is_plain);
  EXPECT_EQ(geometry.projection, Projection::Perspective);
}

TEST(CloudGeometry, NonsenseIsRefused) {
  const PosedCloud cloud = posedRoom();
  EXPECT_EQ(epcc::findGeometry(nullptr, 3, 10, 10).status, Status::EmptyCloud);
  CloudOptions options;
  options.unit = -1.0;
  EXPECT_EQ(geometryOf(cloud, options).status, Status::InvalidParameters);
  options = CloudOptions();
  options.min_depth = 2.0;
  options.max_depth = 1.0;
  const CloudGeometry geometry = geometryOf(cloud, options);
  EXPECT_EQ(geometry.status, Status::InvalidParameters);
  EXPECT_EQ(DepthFrame::fromPoints(cloud.xyz.data(), 3, cloud.width, cloud.height, geometry).status(),
            Status::InvalidParameters);
}

TEST(CloudGeometry, TheFinderRemembersAPoseAndNoticesAnother) {
  epcc::GeometryFinder finder;
  const PosedCloud first = moved(posedRoom(), kTurn, kShift), second = moved(posedRoom(), bodyAxes(), kOrigin);
  const auto find = [&](const PosedCloud& cloud) {
    return finder.find(cloud.xyz.data(), 3, cloud.width, cloud.height).pose;
  };
  const epcc::SensorPose pose = find(first);
  EXPECT_EQ(find(first).origin, pose.origin);
  EXPECT_LT((find(second).axes - bodyAxes()).norm(), 0.01);
  EXPECT_LT((find(first).origin - kShift).norm(), 0.02);
}

TEST(CloudGeometry, CovariancesAreSymmetricToTheLastBit) {
  for (const PosedCloud& cloud : {posedRoom(), epcc::test::scannerCloud(360, 32)}) {
    const Found found = segment(moved(cloud, kTurn, kShift));
    ASSERT_GE(found.result.planes.size(), 2u) << found.error;
    for (const epcc::Plane& plane : found.result.planes) {
      EXPECT_EQ(plane.coefficients_covariance, plane.coefficients_covariance.transpose());
      EXPECT_EQ(plane.points_covariance, plane.points_covariance.transpose());
    }
  }
}

TEST(CloudGeometry, LeastSquaresPlanesAndSensorEstimateAreThoseOfTheSensorsFrame) {
  const PosedCloud plain = posedRoom(), turned = moved(plain, kTurn, kShift);
  const CloudGeometry geometry = geometryOf(turned);
  const auto own = DepthFrame::fromPoints(plain.xyz.data(), 3, plain.width, plain.height, Projection::Perspective);
  const auto frame = DepthFrame::fromPoints(turned.xyz.data(), 3, plain.width, plain.height, geometry);
  PlaneSegmentation a, b;
  a.width = b.width = plain.width;
  a.height = b.height = plain.height;
  a.labels = b.labels = plain.truth;
  const SensorModel sensor = *SensorModel::parse("0.002,0.001,1");
  ASSERT_TRUE(fitPlanes(own, sensor, 3, a));
  ASSERT_TRUE(fitPlanes(frame, sensor, 3, b));
  ASSERT_EQ(a.planes.size(), b.planes.size());
  EXPECT_EQ(a.labels, b.labels);
  for (std::size_t k = 0; k < a.planes.size(); ++k) {
    EXPECT_LT((kTurn * a.planes[k].centroid + kShift - b.planes[k].centroid).norm(), 1e-4);
    EXPECT_NEAR(a.planes[k].rms, b.planes[k].rms, 1e-5);
    const Eigen::Matrix3d turned_covariance = kTurn * a.planes[k].points_covariance * kTurn.transpose();
    EXPECT_LT((turned_covariance - b.planes[k].points_covariance).norm(), 1e-4 * turned_covariance.norm());
    // The variance of the plane's distance at a point does not depend on the frame.
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(0, 0, 2), Eigen::Vector3d(1, -1, 3)}) {
      const Eigen::Vector4d at(p.x(), p.y(), p.z(), 1.0);
      const Eigen::Vector4d there = (kTurn * p + kShift).homogeneous();
      const double variance = at.dot(a.planes[k].coefficients_covariance * at);
      EXPECT_NEAR(there.dot(b.planes[k].coefficients_covariance * there), variance, 0.02 * variance);
    }
  }
  EXPECT_NEAR(estimateSensor(own).a, estimateSensor(frame).a, 0.2 * estimateSensor(own).a + 1e-5);
}

}  // namespace
