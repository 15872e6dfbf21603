// SPDX-License-Identifier: BSD-3-Clause
// Clouds of cameras in every frame, unit and order of pixels: the geometry, the labels, the planes.
#include "epcc_segmentation/cloud_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "epcc_segmentation/plane_fit.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "geometry/sensor_cloud.h"
#include "tests/epcc_segmentation/geometry/found_geometry.h"
#include "tests/support/sanitized.h"

namespace {

using epcc::CloudGeometry;
using epcc::CloudOptions;
using epcc::DepthFrame;
using epcc::Projection;
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

TEST(CameraGeometry, CloudsOfTheUsualFramesAreTakenAsTheyAre) {
  const CloudGeometry forward = geometryOf(posedRoom());
  EXPECT_EQ(forward.status, Status::Ok);
  EXPECT_TRUE(forward.is_plain);
  EXPECT_EQ(forward.projection, Projection::Perspective);
  EXPECT_LT(forward.residual, 1e-4);
  const CloudGeometry backward = geometryOf(moved(posedRoom(), Eigen::Vector3d(1, -1, -1).asDiagonal(), kOrigin));
  EXPECT_TRUE(backward.is_plain);
  EXPECT_EQ(backward.projection, Projection::PerspectiveBackward);
}

TEST(CameraGeometry, PointsThatWereNotMeasuredMayLieBehindTheCameraOrInIt) {
  for (const float factor : {-1.0f, 0.0f}) {  // of z; some drivers write such points where they saw nothing
    PosedCloud cloud = posedRoom();
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

/// The same points with another width and height in the header.
PosedCloud withSize(PosedCloud cloud, int width, int height) {
  cloud.width = width;
  cloud.height = height;
  return cloud;
}

std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

TEST(CameraGeometry, RowsCutOrJoinedAreNoPictureAndTheRightSizeIsNamed) {
  for (const int width : {640, 96}) {
    if (width == 640 && epcc::test::kIsSanitized) continue;
    const int height = width * 3 / 4;
    const auto planes = epcc::test::cornerPlanes();
    const PosedCloud plain =
        epcc::test::cameraCloud(epcc::test::renderRoom(planes, epcc::test::testCamera(width, height)));
    for (const PosedCloud& cloud : {plain, moved(plain, kTurn, kShift)}) {
      ASSERT_EQ(geometryOf(cloud).status, Status::Ok);
      for (const int k : {2, 3, 4}) {
        if (width % k != 0 || height % k != 0) continue;
        const CloudGeometry cut = geometryOf(withSize(cloud, width / k, height * k));
        EXPECT_EQ(cut.status, Status::UnknownGeometry) << width << " / " << k << ": " << cut.residual;
        EXPECT_NE(cut.problem.find("as " + sizeText(width, height) + " they would be a camera's"), std::string::npos)
            << width << " / " << k << ": " << cut.problem;
        const CloudGeometry joined = geometryOf(withSize(cloud, width * k, height / k));
        EXPECT_EQ(joined.status, Status::UnknownGeometry) << width << " * " << k << ": " << joined.residual;
        EXPECT_NE(joined.problem.find("as " + sizeText(width, height)), std::string::npos) << joined.problem;
      }
      EXPECT_EQ(geometryOf(withSize(cloud, height, width)).status, Status::UnknownGeometry) << width;
    }
  }
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
    const PosedCloud cloud = moved(posedRoom(), axes, origin);
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
  const Found plain = segment(posedRoom());
  for (const double unit : {1.0, 1000.0, 100.0}) {
    CloudOptions options;
    options.unit = 1.0 / unit;
    const Found turned = segment(moved(posedRoom(), kTurn, kShift, unit), options);
    ASSERT_EQ(turned.error, "");
    std::size_t same = 0;
    for (std::size_t i = 0; i < plain.result.labels.size(); ++i)
      same += plain.result.labels[i] == turned.result.labels[i] ? 1 : 0;
    EXPECT_GE(same, plain.result.labels.size() * 99 / 100) << unit;
    const Eigen::Vector3d normal = kTurn * plain.result.planes[0].coefficients.head<3>();
    EXPECT_LT((normal - turned.result.planes[0].coefficients.head<3>()).norm(), 1e-3);
  }
}

TEST(CameraGeometry, ATransposedViewHasTheLabelsOfTheCloud) {
  const PosedCloud cloud = moved(posedRoom(), kTurn, kShift);
  const Found upright = segment(cloud);
  ASSERT_EQ(upright.error, "");
  ASSERT_FALSE(upright.geometry.is_plain);
  const DepthFrame frame =
      DepthFrame::fromPoints(cloud.xyz.data(), 3, cloud.width, cloud.height, upright.geometry).transposed();
  epcc::PlaneExtractor extractor(epcc::Parameters(), epcc::SensorModel::parse("0.008,0.001,1"));
  epcc::PlaneSegmentation result;
  ASSERT_TRUE(extractor.extract(frame, result)) << extractor.error();
  EXPECT_EQ(result.width, cloud.height);
  ASSERT_EQ(result.planes.size(), upright.result.planes.size());
  std::size_t same = 0;
  for (std::size_t i = 0; i < result.labels.size(); ++i) same += result.labels[i] == upright.result.labels[i] ? 1 : 0;
  EXPECT_GE(same, result.labels.size() * 97 / 100);
  expectPlanesOnTheirPoints(cloud, {upright.geometry, result, ""}, 1.0, kShift);
}

TEST(CameraGeometry, RowsAndColumnsMayBeExchangedOrReversed) {
  const PosedCloud plain = posedRoom();
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
  const PosedCloud cloud = moved(posedRoom(), kNoTurn, kOrigin, 1000.0);
  const Found guessed = segment(cloud);
  EXPECT_TRUE(guessed.geometry.unit_is_guessed);
  EXPECT_EQ(guessed.geometry.unit, 0.001);
  expectTruth(cloud, guessed.result, 3);
  expectPlanesOnTheirPoints(cloud, guessed, 0.001, kOrigin);
  CloudOptions known;
  known.unit = 0.001;
  EXPECT_FALSE(geometryOf(cloud, known).unit_is_guessed);
  EXPECT_EQ(segment(cloud, known).result.labels, guessed.result.labels);
  EXPECT_FALSE(geometryOf(posedRoom()).unit_is_guessed);
  EXPECT_FALSE(geometryOf(moved(posedRoom(), kNoTurn, Eigen::Vector3d(5000, 0, 0))).unit_is_guessed);  // a map's frame
}

TEST(CameraGeometry, PointsThatManyPixelsShareAreNone) {
  for (const bool is_turned : {false, true})
    for (const Eigen::Vector3f& marker : {Eigen::Vector3f(-1, -1, -1), Eigen::Vector3f(0.5f, 0.5f, 5.0f)}) {
      const PosedCloud plain = is_turned ? moved(posedRoom(), kTurn, kShift) : posedRoom();
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

/// The frame calls those pixels measured that the segmentation, in the sensor's frame, does.
void expectSamePixels(const DepthFrame& frame) {
  epcc::SensorCloud cloud;
  const DepthFrame own = epcc::inSensorFrame(frame, cloud);
  Eigen::Vector3d point;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column)
      EXPECT_EQ(own.point(row, column, point), frame.point(row, column, point)) << row << ' ' << column;
}

// The pose is one that fuzzing found: in single precision the point was before the camera, in double behind it.
TEST(CameraGeometry, APointAtTheSensorIsNoneInEveryPrecision) {
  CloudGeometry geometry;
  geometry.status = Status::Ok;
  geometry.is_plain = false;
  geometry.pose.origin = {0.15624992393341008, 2.5937499836454694, 3.6250001107247201};
  geometry.pose.axes << 0.99951223435752667, 0.031214921532513477, 0.00096023088051566674, -0.031213969790912042,
      0.99951223436781322, -0.00099067600822001604, -0.00099068638675370302, 0.00096022017280367189,
      0.99999904825839858;
  PosedCloud cloud = moved(posedRoom(), geometry.pose.axes, geometry.pose.origin);
  const std::vector<std::size_t> at_sensor = {7, 1000, 5000, 5001, 9000};
  const float place[] = {0.15625f, 2.59375f, 3.625f};
  for (const std::size_t pixel : at_sensor) std::copy_n(place, 3, &cloud.xyz[3 * pixel]);
  const auto frame = DepthFrame::fromPoints(cloud.xyz.data(), 3, cloud.width, cloud.height, geometry);
  expectSamePixels(frame);
  Eigen::Vector3d point;
  for (const std::size_t pixel : at_sensor)
    EXPECT_FALSE(frame.point(static_cast<int>(pixel) / cloud.width, static_cast<int>(pixel) % cloud.width, point));
}

TEST(CameraGeometry, ThePixelAtTheEndOfTheRangeIsTheSameInEveryPrecision) {
  const PosedCloud cloud = moved(posedRoom(), kTurn, kShift);
  const CloudGeometry found = geometryOf(cloud);
  for (std::size_t i = 0; i < cloud.size(); i += cloud.size() / 50) {
    const auto p = Eigen::Map<const Eigen::Vector3f>(&cloud.xyz[3 * i]).cast<double>();
    const double depth = (found.pose.axes.transpose() * (p - found.pose.origin)).z();
    if (!(depth > 0.5)) continue;
    for (double CloudGeometry::*const end : {&CloudGeometry::min_depth, &CloudGeometry::max_depth}) {
      CloudGeometry geometry = found;
      geometry.*end = depth;
      expectSamePixels(DepthFrame::fromPoints(cloud.xyz.data(), 3, cloud.width, cloud.height, geometry));
    }
  }
}

TEST(CameraGeometry, ANamedValueIsNoPointHoweverRare) {
  PosedCloud cloud = posedRoom();
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
  const PosedCloud plain = posedRoom();
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

}  // namespace
