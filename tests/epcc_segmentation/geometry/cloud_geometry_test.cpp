// SPDX-License-Identifier: BSD-3-Clause
// Clouds of cameras and scanners in every frame, unit and order of pixels: the geometry, the labels, the planes.
#include "epcc_segmentation/cloud_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/plane_fit.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "tests/support/posed_clouds.h"

namespace {

using epcc::CloudGeometry;
using epcc::CloudOptions;
using epcc::DepthFrame;
using epcc::PlaneExtractor;
using epcc::PlaneSegmentation;
using epcc::Projection;
using epcc::SensorModel;
using epcc::Status;
using epcc::test::moved;
using epcc::test::PosedCloud;

const Eigen::Matrix3d kNoTurn = Eigen::Matrix3d::Identity();
const Eigen::Vector3d kOrigin = Eigen::Vector3d::Zero();
const Eigen::Vector3d kShift(0.9, -0.5, 0.62);  // 1.2 m
const Eigen::Matrix3d kTurn =
    Eigen::AngleAxisd(25.0 * M_PI / 180.0, Eigen::Vector3d(0.3, 1.0, -0.2).normalized()).toRotationMatrix();

Eigen::Matrix3d bodyAxes() {  // x forward, y left, z up
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return axes;
}

CloudGeometry geometryOf(const PosedCloud& cloud, const CloudOptions& options = CloudOptions()) {
  return epcc::findGeometry(cloud.xyz.data(), 3, cloud.width, cloud.height, options);
}

struct Found {
  CloudGeometry geometry;
  PlaneSegmentation result;
  std::string error;
};

Found segment(const PosedCloud& cloud, const CloudOptions& options = CloudOptions()) {
  Found found;
  found.geometry = geometryOf(cloud, options);
  const bool is_scan = found.geometry.projection == Projection::Spherical;
  PlaneExtractor extractor(epcc::Parameters(), SensorModel::parse(is_scan ? "0.03,0,1" : "0.008,0.001,1"));
  const auto frame = DepthFrame::fromPoints(cloud.xyz.data(), 3, cloud.width, cloud.height, found.geometry);
  extractor.extract(frame, found.result);
  found.error = extractor.error();
  return found;
}

/// Each plane of the truth is one label on nearly all of its pixels.
void expectTruth(const PosedCloud& cloud, const PlaneSegmentation& result, int planes) {
  ASSERT_EQ(result.width, cloud.width);
  ASSERT_EQ(result.height, cloud.height);
  ASSERT_EQ(result.labels.size(), cloud.size());
  EXPECT_EQ(result.planes.size(), static_cast<std::size_t>(planes));
  std::map<std::int32_t, std::map<std::int32_t, int>> votes;
  std::map<std::int32_t, int> count;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.truth[i] == 0) continue;
    ++votes[cloud.truth[i]][result.labels[i]];
    ++count[cloud.truth[i]];
  }
  std::map<std::int32_t, int> used;
  for (const auto& [plane, labels] : votes) {
    const auto best = std::max_element(labels.begin(), labels.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    EXPECT_NE(best->first, 0) << "plane " << plane;
    EXPECT_GE(best->second, 0.95 * count[plane]) << "plane " << plane;
    EXPECT_EQ(++used[best->first], 1) << "plane " << plane;
  }
}

/// The planes go through their points, in metres and in the cloud's frame, and face the sensor.
void expectPlanesOnTheirPoints(const PosedCloud& cloud, const Found& found, double unit,
                               const Eigen::Vector3d& sensor) {
  ASSERT_EQ(found.result.labels.size(), cloud.size());
  std::vector<double> squares(found.result.planes.size(), 0.0), counts(squares);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::int32_t label = found.result.labels[i];
    if (label == 0) continue;
    const Eigen::Vector3d p = unit * Eigen::Map<const Eigen::Vector3f>(&cloud.xyz[3 * i]).cast<double>();
    const double distance = found.result.planes[static_cast<std::size_t>(label - 1)].signedDistance(p);
    squares[static_cast<std::size_t>(label - 1)] += distance * distance;
    counts[static_cast<std::size_t>(label - 1)] += 1.0;
  }
  for (std::size_t k = 0; k < squares.size(); ++k) {
    const epcc::Plane& plane = found.result.planes[k];
    EXPECT_LT(std::sqrt(squares[k] / counts[k]), 0.02) << k;
    EXPECT_GT(plane.signedDistance(sensor), 0.0) << k;
    EXPECT_NEAR(plane.signedDistance(plane.centroid), 0.0, 0.01) << k;
    EXPECT_LT(plane.rms, 0.02) << k;
    EXPECT_NEAR(plane.coefficients.head<3>().norm(), 1.0, 1e-9) << k;
  }
}

PosedCloud room() {
  return epcc::test::cameraCloud(epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera()));
}

TEST(CameraGeometry, CloudsOfTheUsualFramesAreTakenAsTheyAre) {
  const CloudGeometry forward = geometryOf(room());
  EXPECT_EQ(forward.status, Status::Ok);
  EXPECT_TRUE(forward.is_plain);
  EXPECT_EQ(forward.projection, Projection::Perspective);
  EXPECT_LT(forward.residual, 1e-4);
  const CloudGeometry backward = geometryOf(moved(room(), Eigen::Vector3d(1, -1, -1).asDiagonal(), kOrigin));
  EXPECT_TRUE(backward.is_plain);
  EXPECT_EQ(backward.projection, Projection::PerspectiveBackward);
}

TEST(CameraGeometry, PointsThatWereNotMeasuredMayLieBehindTheCameraOrInIt) {
  for (const float factor : {-1.0f, 0.0f}) {  // of z; some drivers write such points where they saw nothing
    PosedCloud cloud = room();
    for (std::size_t i = 0; i < cloud.size(); i += 7) {
      cloud.xyz[3 * i + 2] *= factor;
      if (factor < 0.0f)
        for (std::size_t k = 0; k < 2; ++k) cloud.xyz[3 * i + k] *= factor;
      cloud.truth[i] = 0;
    }
    const Found found = segment(cloud);
    ASSERT_EQ(found.error, "");
    EXPECT_EQ(found.geometry.projection, Projection::Perspective);
    expectTruth(cloud, found.result, 3);
  }
}

TEST(CameraGeometry, HalvesOfRowsBelowEachOtherAreNoPicture) {
  PosedCloud cloud =
      epcc::test::cameraCloud(epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(640, 480)));
  cloud.width /= 2;  // a wrong header
  cloud.height *= 2;
  CloudOptions camera;
  camera.sensor = CloudOptions::Sensor::Camera;
  EXPECT_EQ(epcc::findGeometry(cloud.xyz.data(), 3, cloud.width, cloud.height, camera).status, Status::UnknownGeometry);
}

TEST(CameraGeometry, AnyFrame) {
  const std::vector<std::pair<Eigen::Matrix3d, Eigen::Vector3d>> poses = {
      {bodyAxes(), kOrigin},
      {bodyAxes(), Eigen::Vector3d(0.1, 0.0, 1.2)},
      {kTurn, kOrigin},
      {kTurn, kShift},
      {Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix(), Eigen::Vector3d(40, -70, 3)}};
  for (const auto& [axes, origin] : poses) {
    SCOPED_TRACE(testing::Message() << axes << "\n" << origin.transpose());
    const PosedCloud cloud = moved(room(), axes, origin);
    const Found found = segment(cloud);
    ASSERT_EQ(found.error, "");
    EXPECT_FALSE(found.geometry.is_plain);
    EXPECT_EQ(found.geometry.projection, Projection::Perspective);
    EXPECT_LT((found.geometry.pose.origin - origin).norm(), 0.02);
    EXPECT_LT((found.geometry.pose.axes - axes).norm(), 0.01);
    expectTruth(cloud, found.result, 3);
    expectPlanesOnTheirPoints(cloud, found, 1.0, origin);
  }
}

TEST(CameraGeometry, LabelsAreThoseOfThePlainCloud) {
  const Found plain = segment(room());
  for (const double unit : {1.0, 1000.0, 100.0}) {
    CloudOptions options;
    options.unit = 1.0 / unit;
    const Found turned = segment(moved(room(), kTurn, kShift, unit), options);
    ASSERT_EQ(turned.error, "");
    std::size_t same = 0;
    for (std::size_t i = 0; i < plain.result.labels.size(); ++i)
      same += plain.result.labels[i] == turned.result.labels[i] ? 1 : 0;
    EXPECT_GE(same, plain.result.labels.size() * 99 / 100) << unit;
    const Eigen::Vector3d normal = kTurn * plain.result.planes[0].coefficients.head<3>();
    EXPECT_LT((normal - turned.result.planes[0].coefficients.head<3>()).norm(), 1e-3);
  }
}

TEST(CameraGeometry, RowsAndColumnsMayBeExchangedOrReversed) {
  const PosedCloud plain = room();
  const int width = plain.width, height = plain.height;
  const PosedCloud exchanged = epcc::test::rowsAndColumnsExchanged(plain);
  const PosedCloud upside_down = epcc::test::reordered(plain, width, height, [&](int row, int column) {
    return static_cast<std::size_t>((height - 1 - row) * width + width - 1 - column);
  });
  for (const PosedCloud& order : {exchanged, upside_down})
    for (const bool is_turned : {false, true}) {
      const PosedCloud cloud = is_turned ? moved(order, kTurn, kShift) : order;
      const Found found = segment(cloud);
      ASSERT_EQ(found.error, "");
      expectTruth(cloud, found.result, 3);
      expectPlanesOnTheirPoints(cloud, found, 1.0, is_turned ? kShift : kOrigin);
    }
}

TEST(CameraGeometry, MillimetresAreSeenAndSaid) {
  const PosedCloud cloud = moved(room(), kNoTurn, kOrigin, 1000.0);
  const Found guessed = segment(cloud);
  EXPECT_TRUE(guessed.geometry.unit_is_guessed);
  EXPECT_EQ(guessed.geometry.unit, 0.001);
  expectTruth(cloud, guessed.result, 3);
  expectPlanesOnTheirPoints(cloud, guessed, 0.001, kOrigin);
  CloudOptions known;
  known.unit = 0.001;
  EXPECT_FALSE(geometryOf(cloud, known).unit_is_guessed);
  EXPECT_EQ(segment(cloud, known).result.labels, guessed.result.labels);
  EXPECT_FALSE(geometryOf(room()).unit_is_guessed);
  EXPECT_FALSE(geometryOf(moved(room(), kNoTurn, Eigen::Vector3d(5000, 0, 0))).unit_is_guessed);  // a map's frame
}

TEST(CameraGeometry, PointsThatManyPixelsShareAreNone) {
  for (const bool is_turned : {false, true})
    for (const Eigen::Vector3f& marker : {Eigen::Vector3f(-1, -1, -1), Eigen::Vector3f(0.5f, 0.5f, 5.0f)}) {
      const PosedCloud plain = is_turned ? moved(room(), kTurn, kShift) : room();
      PosedCloud cloud = plain;
      for (std::size_t i = 0; i < cloud.size(); ++i)
        if (i % 7 == 0) {
          Eigen::Map<Eigen::Vector3f>(&cloud.xyz[3 * i]) = marker;
          cloud.truth[i] = 0;
        }
      const Found found = segment(cloud);
      ASSERT_EQ(found.error, "") << marker.transpose();
      expectTruth(cloud, found.result, 3);
      for (std::size_t i = 0; i < cloud.size(); i += 7) ASSERT_EQ(found.result.labels[i], 0);
      EXPECT_EQ(found.geometry.is_plain, !is_turned && marker.z() < 0.0f);
    }
}

TEST(CameraGeometry, ANamedValueIsNoPointHoweverRare) {
  PosedCloud cloud = room();
  for (int k = 0; k < 3; ++k) cloud.xyz[static_cast<std::size_t>(3 * 5000 + k)] = 9.0f;
  CloudOptions options;
  options.invalid = 9.0f;
  const CloudGeometry geometry = geometryOf(cloud, options);
  const auto frame = DepthFrame::fromPoints(cloud.xyz.data(), 3, cloud.width, cloud.height, geometry);
  Eigen::Vector3d p;
  EXPECT_FALSE(frame.point(5000 / cloud.width, 5000 % cloud.width, p));
  EXPECT_TRUE(frame.point(5001 / cloud.width, 5001 % cloud.width, p));
}

TEST(CameraGeometry, DepthsOutOfRangeAreInvalid) {
  const PosedCloud plain = room();
  const PosedCloud cloud = moved(plain, bodyAxes(), kShift);
  CloudOptions options;
  options.min_depth = 1.5;
  options.max_depth = 2.0;
  const Found found = segment(cloud, options);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float z = plain.xyz[3 * i + 2];
    if (z >= 1.49f && z <= 2.01f) continue;
    ASSERT_EQ(found.result.labels[i], 0) << z;
  }
  EXPECT_GE(found.result.planes.size(), 1u);
}

TEST(CameraGeometry, APlaneAloneHasItsPlane) {
  const auto wall =
      epcc::test::renderRoom({Eigen::Vector4d(0.1, 0.05, -0.99, 2.5).normalized() * 1.0}, epcc::test::testCamera());
  for (const Eigen::Vector3d& origin : {kOrigin, kShift}) {
    const PosedCloud cloud = moved(epcc::test::cameraCloud(wall), kTurn, origin);
    const Found found = segment(cloud);
    ASSERT_EQ(found.error, "");
    expectTruth(cloud, found.result, 1);
    expectPlanesOnTheirPoints(cloud, found, 1.0, origin);
  }
}

// ---- scanners ----

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
  const auto shuffled = epcc::test::reordered(plain, width, height, [&](int row, int column) {
    return static_cast<std::size_t>((row % 2 == 0 ? row / 2 : height - 1 - row / 2) * width + column);
  });
  for (const PosedCloud& order : {plain, epcc::test::rowsAndColumnsExchanged(plain), staggered, shuffled,
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
  const PosedCloud cloud = moved(epcc::test::rowsAndColumnsExchanged(epcc::test::scannerCloud(360, 32)), kTurn, kShift);
  const CloudGeometry geometry = geometryOf(cloud);
  epcc::Parameters parameters;
  parameters.line_segments = true;
  PlaneExtractor extractor(parameters, SensorModel::parse("0.008,0,1"));
  PlaneSegmentation result;
  ASSERT_TRUE(
      extractor.extract(DepthFrame::fromPoints(cloud.xyz.data(), 3, cloud.width, cloud.height, geometry), result));
  ASSERT_GT(result.segments.size(), 300u);
  for (const epcc::LineSegment& segment : result.segments) {
    EXPECT_EQ(segment.scan, epcc::ScanDirection::Rows);
    const auto pixel =
        static_cast<std::size_t>(segment.row(segment.first) * cloud.width + segment.column(segment.first));
    const Eigen::Vector3d p = Eigen::Map<const Eigen::Vector3f>(&cloud.xyz[3 * pixel]).cast<double>();
    EXPECT_LT((segment.start - p).norm(), 0.05);
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
  EXPECT_EQ(geometryOf(room(), camera).projection, Projection::Perspective);
}

TEST(CloudGeometry, TooFewPointsCountAsACamera) {
  const std::vector<float> nothing(300, NAN);
  const CloudGeometry geometry = epcc::findGeometry(nothing.data(), 3, 10, 10);
  EXPECT_EQ(geometry.status, Status::Ok);
  EXPECT_TRUE(geometry.is_plain);
  EXPECT_EQ(geometry.projection, Projection::Perspective);
}

TEST(CloudGeometry, NonsenseIsRefused) {
  const PosedCloud cloud = room();
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
  const PosedCloud first = moved(room(), kTurn, kShift), second = moved(room(), bodyAxes(), kOrigin);
  const auto find = [&](const PosedCloud& cloud) {
    return finder.find(cloud.xyz.data(), 3, cloud.width, cloud.height).pose;
  };
  const epcc::SensorPose pose = find(first);
  EXPECT_EQ(find(first).origin, pose.origin);
  EXPECT_LT((find(second).axes - bodyAxes()).norm(), 0.01);
  EXPECT_LT((find(first).origin - kShift).norm(), 0.02);
}

TEST(CloudGeometry, LeastSquaresPlanesAndSensorEstimateAreThoseOfTheSensorsFrame) {
  const PosedCloud plain = room(), turned = moved(plain, kTurn, kShift);
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
