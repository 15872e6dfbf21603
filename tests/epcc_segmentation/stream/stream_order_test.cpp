// SPDX-License-Identifier: BSD-3-Clause
// Lost, late and repeated scan lines, turns without end, and what cannot be a stream.
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "tests/support/rendered_room.h"
#include "tests/support/spinning_scanner.h"
#include "tests/support/streamed_frame.h"

namespace epcc {
namespace {

const SensorModel kOrderSensor = SensorModel::axial(0.003, 0.001, 2.0);

StreamOptions given() {
  StreamOptions options;
  options.sensor = kOrderSensor;
  return options;
}

TEST(StreamOrder, LostColumnsAreScanLinesWithoutASample) {
  auto room = test::renderRoom(test::cornerPlanes(), test::testCamera());
  test::addNoise(room, kOrderSensor, 5);
  const PinholeCamera& camera = room.camera;
  const auto is_lost = [](int c) { return c < 5 || (c >= 50 && c < 53) || (c >= 90 && c < 98) || c >= 150; };
  auto holes = room.depth;
  for (int r = 0; r < camera.height; ++r)
    for (int c = 0; c < camera.width; ++c)
      if (is_lost(c)) holes[static_cast<std::size_t>(r * camera.width + c)] = 0.0f;
  PlaneExtractor extractor(test::wholeFrameParameters({}), kOrderSensor);
  PlaneSegmentation whole;
  ASSERT_TRUE(extractor.extract(DepthFrame::fromDepth(holes.data(), camera), whole));
  ScanLineStream stream(StreamGeometry::cameraColumns(camera), given());
  test::StreamedFrame streamed(stream, camera.width, camera.height);
  for (int c = 0; c < camera.width; ++c) {
    if (is_lost(c)) continue;
    ASSERT_TRUE(stream.addColumn(c, room.depth.data() + c, camera.width)) << stream.error();
  }
  ASSERT_TRUE(stream.finish());
  EXPECT_EQ(stream.taken(), 160 - 5 - 3 - 8 - 10);
  EXPECT_EQ(stream.lost(), 3 + 8);
  test::expectTheFrame(streamed, whole);
  std::size_t over_the_short_gap = 0, over_the_long_gap = 0;
  for (const auto& [id, plane] : streamed.planes()) {
    over_the_short_gap += plane.first_line < 50 && plane.last_line > 53 ? 1 : 0;
    over_the_long_gap += plane.first_line < 90 && plane.last_line > 98 ? 1 : 0;
  }
  EXPECT_GT(over_the_short_gap, 0u);
  EXPECT_EQ(over_the_long_gap, 0u);
}

TEST(StreamOrder, LateAndRepeatedColumnsAreLeftOut) {
  const std::vector<float> depth(30, 2.0f);
  const PinholeCamera camera{40, 30, 30.0, 30.0, 19.5, 14.5};
  ScanLineStream stream(StreamGeometry::cameraColumns(camera), given());
  ASSERT_TRUE(stream.addColumn(3, depth.data()));
  EXPECT_FALSE(stream.addColumn(3, depth.data()));
  EXPECT_EQ(stream.status(), Status::OutOfOrder);
  EXPECT_EQ(stream.error(), "column 3 came twice");
  EXPECT_FALSE(stream.addColumn(1, depth.data()));
  EXPECT_EQ(stream.status(), Status::OutOfOrder);
  EXPECT_EQ(stream.error(), "column 1 came late, after column 3");
  EXPECT_TRUE(stream.addColumn(4, depth.data()));
  EXPECT_EQ(stream.status(), Status::Ok);
  EXPECT_EQ(stream.error(), "");
  for (const std::int64_t index : {std::int64_t{40}, std::int64_t{-1}, std::numeric_limits<std::int64_t>::min()}) {
    EXPECT_FALSE(stream.addColumn(index, depth.data()));
    EXPECT_EQ(stream.status(), Status::SizeMismatch);
  }
  EXPECT_EQ(stream.taken(), 2);
  EXPECT_EQ(stream.lost(), 0);
  EXPECT_EQ(stream.refused(), 2);
  ASSERT_TRUE(stream.finish());
  EXPECT_TRUE(stream.addColumn(0, depth.data())) << "after finish() any index begins";
}

TEST(StreamOrder, ACountOfLostColumnsThatIsFullStaysSo) {
  const test::SpinningScanner scanner;
  std::mt19937 random(1);
  ScanLineStream stream(scanner.geometry(), given());
  const std::int64_t largest = (std::int64_t{1} << 62) - 1;
  for (int jump = 0; jump < 3; ++jump) {
    for (const std::int64_t index : {-largest, largest})
      ASSERT_TRUE(stream.addColumn(index, 0.0, scanner.ranges(0, random).data())) << stream.error();
    EXPECT_EQ(stream.lost(), jump == 0 ? 2 * largest - 1 : std::numeric_limits<std::int64_t>::max()) << jump;
    EXPECT_FALSE(stream.addColumn(largest + 1, 0.0, scanner.ranges(0, random).data()));
    EXPECT_EQ(stream.status(), Status::SizeMismatch);
    ASSERT_TRUE(stream.finish());
  }
}

TEST(StreamOrder, OfAzimuthsCountsLostColumnsAndSeesLateOnes) {
  const test::SpinningScanner scanner;
  std::mt19937 random(1);
  ScanLineStream stream(scanner.geometry(), given());
  const auto add = [&](std::int64_t c, double jitter = 0.0) {
    return stream.addColumnAt(scanner.azimuth(c) + jitter * scanner.azimuthStep(), scanner.ranges(c, random).data());
  };
  for (const std::int64_t c : {350, 351, 352}) ASSERT_TRUE(add(c)) << stream.error();
  EXPECT_TRUE(add(353, 0.3)) << "it does not turn evenly";
  EXPECT_EQ(stream.lost(), 0);
  EXPECT_TRUE(add(360)) << "behind it, where the azimuth changes its sign";
  EXPECT_EQ(stream.lost(), 6);
  EXPECT_FALSE(add(360, 0.2));
  EXPECT_EQ(stream.status(), Status::OutOfOrder);
  EXPECT_FALSE(add(300));
  EXPECT_EQ(stream.status(), Status::OutOfOrder);
  EXPECT_TRUE(add(719));
  EXPECT_TRUE(add(720)) << "the next turn";
  EXPECT_EQ(stream.lost(), 6 + 358);
  EXPECT_FALSE(stream.addColumnAt(NAN, scanner.ranges(0, random).data()));
  EXPECT_EQ(stream.status(), Status::InvalidParameters);
  EXPECT_EQ(stream.refused(), 2);
}

/// The planes of some turns.
std::vector<StreamPlane> planesOf(const test::SpinningScanner& scanner, std::int64_t turns, StreamOptions options) {
  std::mt19937 random(1);
  ScanLineStream stream(scanner.geometry(), options);
  std::vector<StreamPlane> planes;
  stream.onPlane([&](const StreamPlane& plane) { planes.push_back(plane); });
  for (std::int64_t c = 0; c < turns * scanner.columns; ++c)
    EXPECT_TRUE(stream.addColumnAt(scanner.azimuth(c), scanner.ranges(c, random).data())) << stream.error();
  EXPECT_TRUE(stream.finish());
  return planes;
}

// Column 0 looks straight at a wall: that wall lies on both sides of the seam.
TEST(StreamOrder, TheSeamOfATurnCutsNoWallAndEachTurnBeginsThemAnew) {
  test::SpinningScanner scanner;
  scanner.lowest = 60.0;  // it sees the floor in all directions
  scanner.noise = 0.003;
  std::size_t whole_walls = 0, cut_walls = 0, floors = 0;
  for (const StreamPlane& plane : planesOf(scanner, 4, given())) {
    const bool is_floor = plane.plane.coefficients(2) > 0.9;
    const bool is_wall_ahead = plane.plane.coefficients(0) < -0.9 && plane.plane.coefficients(3) > 4.5;
    if (is_floor) floors += plane.is_cut ? 1 : 0;
    if (!is_wall_ahead) continue;
    EXPECT_NEAR(plane.plane.coefficients(3), 5.0, 0.02);
    const std::int64_t seam = (plane.last_line + scanner.columns / 2) / scanner.columns * scanner.columns;
    const bool spans = plane.first_line < seam && plane.last_line > seam;
    (spans ? whole_walls : cut_walls) += 1;
    EXPECT_FALSE(plane.is_cut);
  }
  EXPECT_EQ(whole_walls, 3u) << "at the three seams between four turns";
  EXPECT_EQ(cut_walls, 2u) << "half of it where the stream begins, half where it ends";
  EXPECT_GE(floors, 3u) << "the floor is seen all round and is cut after a turn";
}

TEST(StreamOrder, TheLongestPlaneIsALimitThatCanBeSet) {
  const test::SpinningScanner scanner;
  StreamOptions options = given();
  options.longest_plane = 100;
  for (const StreamPlane& plane : planesOf(scanner, 2, options)) {
    EXPECT_LE(plane.last_line - plane.first_line + 1, 100);
    EXPECT_EQ(plane.is_cut, plane.last_line - plane.first_line + 1 == 100);
  }
}

TEST(StreamOrder, WhatCannotBeAStreamSaysSo) {
  const auto problem = [](const StreamGeometry& geometry, const StreamOptions& options, Status status) {
    ScanLineStream stream(geometry, options);
    const float value[3] = {1.0f, 1.0f, 1.0f};
    EXPECT_EQ(stream.status(), status);
    EXPECT_NE(stream.error(), "");
    EXPECT_FALSE(stream.addPoints(0, value));
    EXPECT_EQ(stream.status(), status) << "it stays";
    EXPECT_FALSE(stream.finish());
    std::vector<StreamPlane> open(1);
    stream.openPlanes(open);
    EXPECT_TRUE(open.empty());
    stream.reset();
    return stream.error();
  };
  const PinholeCamera camera{40, 30, 30.0, 30.0, 19.5, 14.5};
  PinholeCamera bad = camera;
  bad.fx = NAN;
  problem(StreamGeometry::cameraColumns(bad), given(), Status::InvalidCamera);
  bad = camera;
  bad.height = 0;
  problem(StreamGeometry::cameraColumns(bad), given(), Status::InvalidCamera);
  bad.height = 1000000;
  problem(StreamGeometry::cameraColumns(bad), given(), Status::InvalidCamera);
  problem(StreamGeometry::scanner({}, 0.01), given(), Status::InvalidParameters);
  problem(StreamGeometry::scanner({0.1, 0.2, 0.15}, 0.01), given(), Status::InvalidParameters);
  problem(StreamGeometry::scanner({0.1, NAN}, 0.01), given(), Status::InvalidParameters);
  problem(StreamGeometry::scanner({0.1, 2.0}, 0.01), given(), Status::InvalidParameters);
  problem(StreamGeometry::scanner({0.1, 0.2}, 0.0), given(), Status::InvalidParameters);
  problem(StreamGeometry::scanner({0.1, 0.2}, NAN), given(), Status::InvalidParameters);
  problem(StreamGeometry::points(0, Projection::Spherical), given(), Status::InvalidParameters);
  StreamOptions options = given();
  options.lines_at_once = 33;
  EXPECT_EQ(problem(StreamGeometry::cameraColumns(camera), options, Status::InvalidParameters),
            "lines_at_once must be in [1, 32], not 33");
  options = given();
  options.measured_lines = 0;
  problem(StreamGeometry::cameraColumns(camera), options, Status::InvalidParameters);
  options = given();
  options.longest_plane = -1;
  problem(StreamGeometry::cameraColumns(camera), options, Status::InvalidParameters);
  options = given();
  options.paper.max_gap = -1.0;
  problem(StreamGeometry::cameraColumns(camera), options, Status::InvalidParameters);
  options = given();
  options.sensor = SensorModel::axial(NAN, 0.0);
  problem(StreamGeometry::cameraColumns(camera), options, Status::InvalidParameters);
}

TEST(StreamOrder, OfAnotherKindOfScanLinesIsRefusedWithTheRightCall) {
  const std::vector<float> values(64, 1.0f);
  ScanLineStream scanner(test::SpinningScanner().geometry(), given());
  EXPECT_FALSE(scanner.addColumn(0, values.data()));
  EXPECT_EQ(scanner.status(), Status::UnsupportedScan);
  EXPECT_NE(scanner.error().find("addColumnAt"), std::string::npos) << scanner.error();
  ScanLineStream rows(StreamGeometry::cameraRows({40, 30, 30.0, 30.0, 19.5, 14.5}), given());
  EXPECT_FALSE(rows.addColumn(0, values.data()));
  EXPECT_NE(rows.error().find("addRow"), std::string::npos) << rows.error();
  EXPECT_FALSE(rows.addRow(0, static_cast<const float*>(nullptr)));
  EXPECT_EQ(rows.status(), Status::EmptyCloud);
  EXPECT_TRUE(rows.addRow(0, values.data()));
  ScanLineStream points(StreamGeometry::points(2, Projection::Spherical), given());
  EXPECT_FALSE(points.addPoints(0, values.data(), 2));
  EXPECT_EQ(points.status(), Status::SizeMismatch);
}

TEST(StreamOrder, WhatACallbackThrowsEndsTheStreamUntilReset) {
  const PinholeCamera camera{40, 30, 30.0, 30.0, 19.5, 14.5};
  const std::vector<float> depth(30, 2.0f);
  ScanLineStream stream(StreamGeometry::cameraColumns(camera), given());
  bool throws = true;
  int planes = 0;
  stream.onPlane([&](const StreamPlane&) {
    if (throws) throw std::runtime_error("the disk is full");
    ++planes;
  });
  for (int c = 0; c < 40; ++c) ASSERT_TRUE(stream.addColumn(c, depth.data()));
  EXPECT_FALSE(stream.finish());
  EXPECT_EQ(stream.status(), Status::Failed);
  EXPECT_EQ(stream.error(), "the disk is full");
  EXPECT_FALSE(stream.addColumn(41, depth.data()));
  EXPECT_EQ(stream.status(), Status::Failed);
  stream.reset();
  throws = false;
  for (int c = 0; c < 40; ++c) ASSERT_TRUE(stream.addColumn(c, depth.data())) << stream.error();
  EXPECT_TRUE(stream.finish());
  EXPECT_EQ(planes, 1);
}

TEST(StreamOrder, AnEmptyStreamFinishes) {
  StreamOptions options;  // the sensor is to be measured
  ScanLineStream stream(test::SpinningScanner().geometry(), options);
  EXPECT_TRUE(stream.finish());
  const std::vector<float> nothing(32, NAN);
  for (int c = 0; c < 50; ++c) EXPECT_TRUE(stream.addColumnAt(-2.0 * M_PI / 720 * c, nothing.data()));
  EXPECT_TRUE(stream.finish());
  EXPECT_EQ(stream.measuredBlocks(), 0u);
}

}  // namespace
}  // namespace epcc
