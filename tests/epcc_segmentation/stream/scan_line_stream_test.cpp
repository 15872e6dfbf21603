// SPDX-License-Identifier: BSD-3-Clause
// A stream of scan lines finds what the whole frame's scan finds, to the pixel, however it is fed.
#include "epcc_segmentation/scan_line_stream.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/rendered_room.h"
#include "tests/support/spinning_scanner.h"
#include "tests/support/streamed_frame.h"

namespace epcc {
namespace {

const SensorModel kSensor = SensorModel::axial(0.003, 0.001, 2.0);

StreamOptions optionsOf(int lines_at_once = 32) {
  StreamOptions options;
  options.sensor = kSensor;
  options.lines_at_once = lines_at_once;
  return options;
}

test::RenderedRoom noisyRoom(int width = 160, int height = 120) {
  auto room = test::renderRoom(test::cornerPlanes(), test::testCamera(width, height));
  test::addNoise(room, kSensor, 5);
  std::mt19937 random(7);
  for (float& z : room.depth) {  // holes, and what is not in front of the camera
    const auto draw = random() % 100;
    if (draw < 4) z = draw == 0 ? NAN : draw == 1 ? -z : draw == 2 ? INFINITY : 0.0f;
  }
  for (int column = 60; column < 63; ++column)  // scan lines without a sample
    for (int row = 0; row < height; ++row) room.depth[static_cast<std::size_t>(row * width + column)] = 0.0f;
  return room;
}

TEST(ScanLineStream, HasTheLabelsAndPlanesOfTheWholeFrameByColumnsAndByRows) {
  const auto room = noisyRoom();
  for (const bool rows : {false, true}) {
    SCOPED_TRACE(rows ? "rows" : "columns");
    test::expectTheWholeFrame(room.frame(), room.depth.data(), room.camera, rows, optionsOf());
  }
}

TEST(ScanLineStream, DoesNotDependOnHowManyLinesAlgorithm1Takes) {
  const auto room = noisyRoom(101, 75);
  for (const int lines : {1, 7, 16, 31}) {
    SCOPED_TRACE(lines);
    test::expectTheWholeFrame(room.frame(), room.depth.data(), room.camera, false, optionsOf(lines));
  }
}

TEST(ScanLineStream, FollowsTheParameters) {
  const auto room = noisyRoom();
  StreamOptions options = optionsOf(5);
  options.paper.line_k_max = 1.0;
  options.paper.min_segments = 3;
  options.paper.min_points = 60;
  options.paper.expert.planes.look_back = 9;
  options.paper.expert.planes.pair_look_back = 9;
  options.paper.expert.lines.fit_samples = 4;
  for (const PlaneCriterion criterion : {PlaneCriterion::PrototypeSensorSegment, PlaneCriterion::Prototype}) {
    options.paper.criterion = criterion;
    test::expectTheWholeFrame(room.frame(), room.depth.data(), room.camera, false, options);
  }
  options = optionsOf();
  options.paper.min_segments = 1;
  options.paper.expert.planes.look_back = 1;
  options.paper.expert.planes.pair_look_back = 1;
  test::expectTheWholeFrame(room.frame(), room.depth.data(), room.camera, true, options);
}

TEST(ScanLineStream, FindsTheSameAgainAfterFinish) {
  const auto room = noisyRoom();
  ScanLineStream stream(StreamGeometry::cameraColumns(room.camera), optionsOf());
  std::size_t found[2] = {};
  std::int64_t largest_id = 0;
  for (std::size_t& count : found) {
    test::StreamedFrame streamed(stream, room.camera.width, room.camera.height);
    for (int c = 0; c < room.camera.width; ++c)
      ASSERT_TRUE(stream.addColumn(c, room.depth.data() + c, room.camera.width)) << stream.error();
    ASSERT_TRUE(stream.finish());
    count = streamed.planes().size();
    ASSERT_GT(count, 0u);
    EXPECT_GT(streamed.planes().begin()->first, largest_id) << "ids go on";
    largest_id = streamed.planes().rbegin()->first;
  }
  EXPECT_EQ(found[0], found[1]);
  stream.reset();
  EXPECT_EQ(stream.taken(), 0);
}

/// One turn as an organized cloud: x forward, y left, z up.
std::vector<float> cloudOf(const test::SpinningScanner& scanner, const std::vector<std::vector<float>>& turn) {
  const auto elevations = scanner.elevations();
  std::vector<float> xyz;
  for (std::size_t ring = 0; ring < elevations.size(); ++ring)
    for (std::size_t column = 0; column < turn.size(); ++column) {
      const double azimuth = scanner.azimuth(static_cast<std::int64_t>(column));
      const auto range = static_cast<double>(turn[column][ring]);
      xyz.push_back(static_cast<float>(range * std::cos(elevations[ring]) * std::cos(azimuth)));
      xyz.push_back(static_cast<float>(range * std::cos(elevations[ring]) * std::sin(azimuth)));
      xyz.push_back(static_cast<float>(range * std::sin(elevations[ring])));
    }
  return xyz;
}

std::vector<std::vector<float>> turnOf(const test::SpinningScanner& scanner, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::vector<float>> turn;
  for (int column = 0; column < scanner.columns; ++column) turn.push_back(scanner.ranges(column, random));
  return turn;
}

TEST(ScanLineStream, OfATurnOfAScannerIsItsCloudSegmentedWhole) {
  test::SpinningScanner scanner;
  scanner.noise = 0.004;
  const auto turn = turnOf(scanner, 3);
  const std::vector<float> xyz = cloudOf(scanner, turn);
  const StreamOptions options = optionsOf();
  PlaneExtractor extractor(test::wholeFrameParameters(options.paper), options.sensor);
  PlaneSegmentation whole;
  const auto frame = DepthFrame::fromPoints(xyz.data(), 3, scanner.columns, scanner.rings, Projection::Spherical);
  ASSERT_TRUE(extractor.extract(frame, whole)) << extractor.error();
  ASSERT_GE(whole.planes.size(), 5u) << "floor and four walls";
  {
    SCOPED_TRACE("ranges");
    ScanLineStream stream(scanner.geometry(), options);
    test::StreamedFrame streamed(stream, scanner.columns, scanner.rings);
    for (int c = 0; c < scanner.columns; ++c)
      ASSERT_TRUE(stream.addColumn(c, scanner.azimuth(c), turn[static_cast<std::size_t>(c)].data())) << stream.error();
    ASSERT_TRUE(stream.finish());
    test::expectTheFrame(streamed, whole);
  }
  {
    SCOPED_TRACE("ranges at azimuths");
    ScanLineStream stream(scanner.geometry(), options);
    test::StreamedFrame streamed(stream, scanner.columns, scanner.rings);
    for (int c = 0; c < scanner.columns; ++c)
      ASSERT_TRUE(stream.addColumnAt(scanner.azimuth(c), turn[static_cast<std::size_t>(c)].data())) << stream.error();
    ASSERT_TRUE(stream.finish());
    EXPECT_EQ(stream.lost(), 0);
    test::expectTheFrame(streamed, whole);
  }
  SCOPED_TRACE("points");
  test::expectTheWholeCloud(xyz.data(), 3, scanner.columns, scanner.rings, Projection::Spherical, options, 5);
}

TEST(ScanLineStream, OfACamerasCloudIsTheCloudSegmentedWhole) {
  const auto room = noisyRoom();
  const auto points = static_cast<std::size_t>(room.camera.width * room.camera.height);
  for (const Projection projection : {Projection::Perspective, Projection::PerspectiveBackward}) {
    std::vector<float> xyz(4 * points, NAN);
    const float sign = projection == Projection::Perspective ? 1.0f : -1.0f;
    Eigen::Vector3d p;
    for (int row = 0; row < room.camera.height; ++row)
      for (int column = 0; column < room.camera.width; ++column) {
        if (!room.frame().point(row, column, p)) continue;
        float* to = xyz.data() + 4 * (row * room.camera.width + column);
        to[0] = static_cast<float>(p.x());
        to[1] = sign * static_cast<float>(p.y());
        to[2] = sign * static_cast<float>(p.z());
      }
    test::expectTheWholeCloud(xyz.data(), 4, room.camera.width, room.camera.height, projection, optionsOf(), 3);
  }
}

TEST(ScanLineStream, OfAnUnknownWidthIsThatOfTheFrame) {
  const auto room = noisyRoom();
  PlaneExtractor extractor(test::wholeFrameParameters({}), kSensor);
  PlaneSegmentation whole;
  ASSERT_TRUE(extractor.extract(room.frame(), whole));
  PinholeCamera unbounded = room.camera;
  unbounded.width = 0;
  ScanLineStream stream(StreamGeometry::cameraColumns(unbounded), optionsOf());
  test::StreamedFrame streamed(stream, room.camera.width, room.camera.height);
  for (int c = 0; c < room.camera.width; ++c)
    ASSERT_TRUE(stream.addColumn(c, room.depth.data() + c, room.camera.width)) << stream.error();
  ASSERT_TRUE(stream.finish());
  test::expectTheFrame(streamed, whole);
}

TEST(ScanLineStream, MeasuresTheSensorAsTheWholeFrameDoes) {
  auto room = test::renderRoom(test::cornerPlanes(), test::testCamera(320, 240));
  test::addNoise(room, kSensor, 5);
  for (const bool rows : {false, true}) {
    SCOPED_TRACE(rows ? "rows" : "columns");
    test::expectTheWholeFrame(room.frame(), room.depth.data(), room.camera, rows, StreamOptions());
  }
  StreamOptions options;
  options.measured_lines = 200;
  ScanLineStream stream(StreamGeometry::cameraColumns(room.camera), options);
  for (int c = 0; c < 200; ++c) ASSERT_TRUE(stream.addColumn(c, room.depth.data() + c, room.camera.width));
  EXPECT_TRUE(stream.isMeasuring());
  EXPECT_EQ(stream.measuredBlocks(), 0u);
  ASSERT_TRUE(stream.addColumn(200, room.depth.data() + 200, room.camera.width));
  EXPECT_FALSE(stream.isMeasuring());
  EXPECT_GT(stream.measuredBlocks(), 10u);
  EXPECT_NEAR(stream.sensor().sigmaZ(2.0), kSensor.sigmaZ(2.0), 0.7 * kSensor.sigmaZ(2.0));
}

TEST(ScanLineStream, ShowsOpenPlanesAsTheyGrow) {
  const auto room = noisyRoom();
  ScanLineStream stream(StreamGeometry::cameraColumns(room.camera), optionsOf(1));
  std::vector<StreamPlane> handed_out, open;
  stream.onPlane([&](const StreamPlane& plane) { handed_out.push_back(plane); });
  std::size_t most = 0, last_count = 0;
  for (int c = 0; c < room.camera.width; ++c) {
    ASSERT_TRUE(stream.addColumn(c, room.depth.data() + c, room.camera.width));
    stream.openPlanes(open);
    EXPECT_TRUE(c > 10 || open.empty()) << "none has 15 segments";
    most = std::max(most, open.size());
    for (const StreamPlane& plane : open) {
      EXPECT_LE(plane.last_line, c);
      EXPECT_GE(plane.last_line, c - 4);
      if (plane.id != 1) continue;
      EXPECT_GE(plane.plane.pixel_count, last_count);
      last_count = plane.plane.pixel_count;
    }
  }
  EXPECT_GE(most, 2u);
  ASSERT_TRUE(stream.finish());
  stream.openPlanes(open);
  EXPECT_TRUE(open.empty());
  ASSERT_GE(handed_out.size(), 3u);
}

}  // namespace
}  // namespace epcc
