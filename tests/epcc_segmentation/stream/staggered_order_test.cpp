// SPDX-License-Identifier: BSD-3-Clause
// Staggered rings: to either side, lost columns, turns without end, the sensor measured, and what cannot be.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/staggered_scanner.h"
#include "tests/support/streamed_frame.h"

namespace epcc {
namespace {

TEST(StaggeredOrder, OfOffsetsBelowHalfAStepNeedNoOtherColumn) {
  test::SpinningScanner scanner = test::staggeredScanner();
  for (double& azimuth : scanner.ring_azimuths) azimuth = std::copysign(0.3, azimuth) * scanner.azimuthStep();
  const test::RingShifts shifts(scanner.geometry());
  EXPECT_EQ(shifts.least, 0);
  EXPECT_EQ(shifts.most, 0);
  const auto columns = test::columnsOf(scanner, scanner.columns);
  const std::vector<float> xyz = test::cloudOf(scanner, columns, true);
  PlaneExtractor extractor(test::wholeFrameParameters({}), test::kStaggeredSensor);
  PlaneSegmentation whole;
  const auto cloud = DepthFrame::fromPoints(xyz.data(), 3, scanner.columns, scanner.rings, Projection::Spherical);
  ASSERT_TRUE(extractor.extract(cloud, whole));
  ScanLineStream stream(scanner.geometry(), test::staggeredOptions());
  test::StreamedFrame streamed(stream, scanner.columns, scanner.rings);
  test::addAll(scanner, columns, stream);
  test::expectTheFrame(streamed, whole);
}

// All rings on one side: no scan line has its own column among those it is made of.
TEST(StaggeredOrder, MayAllBeOnOneSideAndTurnEitherWay) {
  test::SpinningScanner scanner = test::staggeredScanner(0.0);
  for (double& azimuth : scanner.ring_azimuths) azimuth += 12.0 * scanner.azimuthStep();
  ASSERT_LT(test::RingShifts(scanner.geometry()).most, 0);
  const auto columns = test::columnsOf(scanner, scanner.columns);
  std::vector<StreamPlane> planes[2];
  std::vector<double> azimuths;
  ScanLineStream clockwise(scanner.geometry(), test::staggeredOptions());
  clockwise.onPlane([&](const StreamPlane& plane) { planes[0].push_back(plane); });
  clockwise.onLine([&](const LabelledLine& line) {
    EXPECT_NEAR(std::remainder(line.azimuth - scanner.azimuth(line.index), 2.0 * M_PI), 0.0, 1e-9) << line.index;
  });
  test::addAll(scanner, columns, clockwise);
  // A mirrored scanner turns counter-clockwise, in a mirrored room.
  std::vector<double> mirrored = scanner.ring_azimuths;
  for (double& azimuth : mirrored) azimuth = -azimuth;
  ScanLineStream other(StreamGeometry::scanner(scanner.elevations(), -scanner.azimuthStep(), mirrored),
                       test::staggeredOptions());
  other.onPlane([&](const StreamPlane& plane) { planes[1].push_back(plane); });
  for (std::size_t i = 0; i < columns.size(); ++i)
    ASSERT_TRUE(other.addColumnAt(-scanner.azimuth(static_cast<std::int64_t>(i)), columns[i].data())) << other.error();
  ASSERT_TRUE(other.finish());
  ASSERT_GE(planes[0].size(), 5u);
  ASSERT_EQ(planes[0].size(), planes[1].size());
  for (std::size_t i = 0; i < planes[0].size(); ++i) {
    EXPECT_EQ(planes[0][i].first_line, planes[1][i].first_line);
    EXPECT_EQ(planes[0][i].plane.pixel_count, planes[1][i].plane.pixel_count);
    const Eigen::Vector4d mirror(1.0, -1.0, 1.0, 1.0);
    test::expectNear(Vector4(planes[0][i].plane.coefficients.cwiseProduct(mirror)),
                     Vector4(planes[1][i].plane.coefficients), 1e-7);
  }
}

TEST(StaggeredOrder, OfLostColumnsAreNotMeasuredInTheirScanLines) {
  const test::SpinningScanner scanner = test::staggeredScanner();
  const test::RingShifts shifts(scanner.geometry());
  const int lines = scanner.columns + shifts.most - shifts.least;
  auto columns = test::columnsOf(scanner, scanner.columns);
  // Some, more than look_back, and more than the rings are apart.
  const auto is_lost = [](int c) { return c == 100 || (c >= 200 && c < 207) || (c >= 400 && c < 440); };
  ScanLineStream stream(scanner.geometry(), test::staggeredOptions(7));
  test::StreamedFrame streamed(stream, lines, scanner.rings, -shifts.most);
  for (int c = 0; c < scanner.columns; ++c) {
    std::vector<float>& column = columns[static_cast<std::size_t>(c)];
    if (is_lost(c))
      column.assign(column.size(), NAN);
    else
      ASSERT_TRUE(stream.addColumn(c, scanner.azimuth(c), column.data())) << stream.error();
  }
  EXPECT_FALSE(stream.addColumn(300, scanner.azimuth(300), columns[300].data()));
  EXPECT_EQ(stream.status(), Status::OutOfOrder);
  ASSERT_TRUE(stream.finish());
  EXPECT_EQ(stream.lost(), 1 + 7 + 40);
  EXPECT_EQ(stream.refused(), 1);
  EXPECT_EQ(streamed.linesHandedOut(), lines - (40 - (shifts.most - shifts.least)))
      << "lines that no column came for are left out";
  const std::vector<float> xyz = test::cloudOf(scanner, columns, true);
  PlaneExtractor extractor(test::wholeFrameParameters({}), test::kStaggeredSensor);
  PlaneSegmentation whole;
  ASSERT_TRUE(
      extractor.extract(DepthFrame::fromPoints(xyz.data(), 3, lines, scanner.rings, Projection::Spherical), whole));
  test::expectTheFrame(streamed, whole);
}

TEST(StaggeredOrder, GoOnOverTheSeamAndBeginAnewAfterFinishAndReset) {
  const test::SpinningScanner scanner = test::staggeredScanner();
  const auto columns = test::columnsOf(scanner, scanner.columns);
  ScanLineStream stream(scanner.geometry(), test::staggeredOptions());
  std::size_t counts[3] = {};
  for (std::size_t& count : counts) {
    stream.onPlane([&count](const StreamPlane&) { ++count; });
    test::addAll(scanner, columns, stream);
    if (&count == &counts[1]) {
      stream.onPlane(nullptr);
      for (int c = 0; c < 100; ++c) ASSERT_TRUE(stream.addColumnAt(scanner.azimuth(c), columns[0].data()));
      stream.reset();
      EXPECT_EQ(stream.taken(), 0);
    }
  }
  EXPECT_GE(counts[0], 5u);
  EXPECT_EQ(counts[0], counts[1]);
  EXPECT_EQ(counts[0], counts[2]);
  std::size_t over_the_seam = 0;
  stream.onPlane([&](const StreamPlane& plane) {
    const bool is_wall = std::abs(plane.plane.coefficients(2)) < 0.1;
    over_the_seam += is_wall && plane.first_line < scanner.columns && plane.last_line > scanner.columns ? 1 : 0;
  });
  for (int c = 0; c < 2 * scanner.columns; ++c)
    ASSERT_TRUE(stream.addColumnAt(scanner.azimuth(c), columns[static_cast<std::size_t>(c % scanner.columns)].data()));
  ASSERT_TRUE(stream.finish());
  EXPECT_EQ(over_the_seam, 1u) << "the wall ahead";
}

TEST(StaggeredOrder, HaveTheirSensorMeasured) {
  const test::SpinningScanner scanner = test::staggeredScanner();
  StreamOptions options;
  options.measured_lines = 400;
  ScanLineStream stream(scanner.geometry(), options);
  std::size_t planes = 0;
  stream.onPlane([&planes](const StreamPlane&) { ++planes; });
  test::addAll(scanner, test::columnsOf(scanner, scanner.columns), stream);
  EXPECT_FALSE(stream.isMeasuring());
  EXPECT_GT(stream.measuredBlocks(), 10u);
  EXPECT_NEAR(stream.sensor().sigmaZ(4.0), 0.004, 0.002);
  EXPECT_GE(planes, 5u);
}

TEST(StaggeredOrder, ThatCannotBeSaySo) {
  const std::vector<double> elevations{0.2, 0.1, 0.0};
  const auto problem = [&](const std::vector<double>& azimuths, double step = 0.01) {
    const StreamGeometry geometry = StreamGeometry::scanner(elevations, step, azimuths);
    ScanLineStream stream(geometry, test::staggeredOptions());
    EXPECT_EQ(stream.error(), geometry.validate());
    EXPECT_EQ(stream.status(), geometry.validate().empty() ? Status::Ok : Status::InvalidParameters);
    const float ranges[3] = {1.0f, 1.0f, 1.0f};
    EXPECT_EQ(stream.addColumnAt(0.0, ranges), geometry.validate().empty());
    return stream.error();
  };
  EXPECT_EQ(problem({}), "");
  EXPECT_EQ(problem({0.0, 0.0, 0.0}), "");
  EXPECT_EQ(problem({0.1, 0.0, -0.1}), "");
  EXPECT_EQ(problem({0.1, 0.0}), "there must be a ring azimuth for each of the 3 elevations, not 2");
  EXPECT_EQ(problem({0.1, 0.0, 0.0, 0.0}), "there must be a ring azimuth for each of the 3 elevations, not 4");
  const char* too_far = "ring azimuths must lie within pi/4 radians of the column's";
  EXPECT_EQ(problem({0.1, NAN, 0.0}), too_far);
  EXPECT_EQ(problem({0.1, INFINITY, 0.0}), too_far);
  EXPECT_EQ(problem({0.1, 0.0, -1e300}), too_far);
  EXPECT_EQ(problem({3.1, 1.0, -3.1}), too_far) << "degrees";
  EXPECT_EQ(problem({0.5, 0.0, 0.0}, 1e-4), "ring azimuths must be at most 4096 columns apart, not 5000");
  EXPECT_EQ(problem({0.0, 0.4, 0.2}, 1e-4), "");
  EXPECT_NE(problem({0.1, 0.0, 0.0}, 0.0), "") << "the step is none";
  EXPECT_EQ(StreamGeometry::scanner(elevations, 0.01, {0.1, 0.0, 0.0}).ringShift(5), 0);
  EXPECT_EQ(StreamGeometry::scanner(elevations, 0.01).ringShift(0), 0);
  EXPECT_FALSE(StreamGeometry::scanner(elevations, 0.01, {0.0, 0.0, 0.0}).isStaggered());
}

}  // namespace
}  // namespace epcc
