// SPDX-License-Identifier: BSD-3-Clause
// A scanner whose rings look at different azimuths: its stream is the cloud whose columns have one azimuth.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "epcc_segmentation/vector_unit.h"
#include "tests/support/staggered_scanner.h"
#include "tests/support/streamed_frame.h"

namespace epcc {
namespace {

TEST(StaggeredRings, AreTheAlignedCloudSegmentedWholeOnEveryVectorUnit) {
  const std::string before = vectorUnit();
  const test::SpinningScanner scanner = test::staggeredScanner();
  const test::RingShifts shifts(scanner.geometry());
  const auto columns = test::columnsOf(scanner, scanner.columns);
  const int lines = scanner.columns + shifts.most - shifts.least;
  const std::vector<float> xyz = test::cloudOf(scanner, columns, true);
  for (const std::string& unit : vectorUnits()) {
    ASSERT_TRUE(setVectorUnit(unit));
    PlaneExtractor extractor(test::wholeFrameParameters({}), test::kStaggeredSensor);
    PlaneSegmentation whole;
    const auto cloud = DepthFrame::fromPoints(xyz.data(), 3, lines, scanner.rings, Projection::Spherical);
    ASSERT_TRUE(extractor.extract(cloud, whole)) << extractor.error();
    ASSERT_GE(whole.planes.size(), 5u);
    for (const bool at_azimuths : {false, true}) {
      SCOPED_TRACE(unit + (at_azimuths ? ", at azimuths" : ", by index"));
      ScanLineStream stream(scanner.geometry(), test::staggeredOptions(at_azimuths ? 32 : 5));
      test::StreamedFrame streamed(stream, lines, scanner.rings, -shifts.most);
      test::addAll(scanner, columns, stream, at_azimuths);
      EXPECT_EQ(streamed.linesHandedOut(), lines);
      EXPECT_EQ(stream.taken(), scanner.columns);
      EXPECT_EQ(stream.lost(), 0);
      test::expectTheFrame(streamed, whole);
    }
  }
  setVectorUnit(before);
}

// What PlaneExtractor does with a cloud as it came, given the shifts of its rings. Half a turn, for the cloud of a
// whole one closes and has no first scan line.
TEST(StaggeredRings, AreTheCloudAsItCameSegmentedWholeWithTheGridOfItsRings) {
  const test::SpinningScanner scanner = test::staggeredScanner();
  const test::RingShifts shifts(scanner.geometry());
  const auto columns = test::columnsOf(scanner, scanner.columns / 2);
  const int width = scanner.columns / 2;
  const std::vector<float> xyz = test::cloudOf(scanner, columns, false);
  CloudGeometry geometry;
  geometry.status = Status::Ok;
  geometry.is_plain = false;
  geometry.projection = Projection::Spherical;
  geometry.grid.margin = shifts.most - shifts.least;
  for (const int shift : shifts.of) geometry.grid.ring_shift.push_back(shift - shifts.most);
  PlaneExtractor extractor(test::wholeFrameParameters({}), test::kStaggeredSensor);
  PlaneSegmentation whole;
  ASSERT_TRUE(extractor.extract(DepthFrame::fromPoints(xyz.data(), 3, width, scanner.rings, geometry), whole));
  ASSERT_GE(whole.planes.size(), 3u);
  ScanLineStream stream(scanner.geometry(), test::staggeredOptions());
  test::StreamedFrame streamed(stream, width + geometry.grid.margin, scanner.rings, -shifts.most);
  test::addAll(scanner, columns, stream);

  std::map<std::int64_t, std::int32_t> label_of{{0, 0}};
  int different = 0, labelled = 0;
  for (int ring = 0; ring < scanner.rings; ++ring)
    for (int column = 0; column < width; ++column) {
      // Back to the column that the sample came with, as ringShift() says.
      const int line = column - scanner.geometry().ringShift(ring);
      const std::int64_t id = streamed.label(line + shifts.most, ring);
      const std::int32_t label = whole.labels[static_cast<std::size_t>(ring * width + column)];
      different += label_of.emplace(id, label).first->second == label ? 0 : 1;
      labelled += label > 0 ? 1 : 0;
    }
  EXPECT_EQ(different, 0);
  EXPECT_GT(labelled, width * scanner.rings / 2);
  ASSERT_EQ(streamed.planes().size(), whole.planes.size());
  for (const auto& [id, plane] : streamed.planes())
    test::expectThePlane(plane.plane, whole.planes[static_cast<std::size_t>(label_of[id]) - 1]);
}

TEST(StaggeredRings, LagByAsManyColumnsAsFindGeometryFinds) {
  const test::SpinningScanner scanner = test::staggeredScanner(0.0, 0.0);
  const test::RingShifts shifts(scanner.geometry());
  EXPECT_EQ(shifts.of[0], -6) << "its ray is six columns ahead";
  EXPECT_EQ(shifts.of[3], 7);
  const auto columns = test::columnsOf(scanner, scanner.columns / 2);
  const std::vector<float> xyz = test::cloudOf(scanner, columns, false);
  const CloudGeometry found = findGeometry(xyz.data(), 3, scanner.columns / 2, scanner.rings);
  ASSERT_EQ(found.status, Status::Ok) << found.problem;
  ASSERT_EQ(found.projection, Projection::Spherical);
  ASSERT_EQ(found.grid.ring_shift.size(), shifts.of.size());
  EXPECT_EQ(found.grid.margin, shifts.most - shifts.least);
  for (std::size_t ring = 0; ring < shifts.of.size(); ++ring)
    EXPECT_EQ(found.grid.ring_shift[ring], shifts.of[ring] - shifts.most) << ring;
}

/// The planes of the room as the scanner sees them, (a, b, c, d) towards it.
std::vector<Eigen::Vector4d> roomOf(const test::SpinningScanner& scanner) {
  std::vector<Eigen::Vector4d> planes = {{0.0, 0.0, 1.0, 1.5}};
  const double distances[] = {5.0, 2.5, 3.0, 3.5};  // ahead, left, behind, right of the room's x axis
  for (int i = 0; i < 4; ++i) {
    const double towards = 0.5 * M_PI * i - scanner.heading;
    planes.emplace_back(-std::cos(towards), -std::sin(towards), 0.0, distances[i]);
  }
  return planes;
}

/// Points on planes that are one of the room's, within a tolerance.
std::size_t pointsOnTheRoom(const std::vector<StreamPlane>& found, const test::SpinningScanner& scanner,
                            double tolerance) {
  std::size_t points = 0;
  for (const StreamPlane& plane : found)
    for (const Eigen::Vector4d& exact : roomOf(scanner))
      if ((plane.plane.coefficients - exact).cwiseAbs().maxCoeff() < tolerance) points += plane.plane.pixel_count;
  return points;
}

TEST(StaggeredRings, ShowTheExactPlanesOfARoomAtAnyHeading) {
  for (const double heading : {0.0, 0.4, M_PI / 4, 1.3, -2.5}) {
    SCOPED_TRACE(heading);
    test::SpinningScanner scanner = test::staggeredScanner(0.0);
    scanner.heading = heading;
    const auto columns = test::columnsOf(scanner, 2 * scanner.columns);
    std::size_t measured = 0;
    for (const auto& column : columns)
      for (const float range : column) measured += range > 0.0f ? 1 : 0;
    std::vector<StreamPlane> planes;
    ScanLineStream stream(scanner.geometry(), test::staggeredOptions());
    stream.onPlane([&planes](const StreamPlane& plane) { planes.push_back(plane); });
    test::addAll(scanner, columns, stream, true);
    const std::size_t exact = pointsOnTheRoom(planes, scanner, 1e-3);
    EXPECT_GT(exact, measured * 9 / 10) << "of " << measured;
    for (const Eigen::Vector4d& wanted : roomOf(scanner))
      EXPECT_TRUE(std::any_of(planes.begin(), planes.end(), [&](const StreamPlane& plane) {
        return (plane.plane.coefficients - wanted).cwiseAbs().maxCoeff() < 1e-3;
      })) << wanted.transpose();

    // The same ranges without the rings' azimuths: the room is torn.
    test::SpinningScanner straight = scanner;
    straight.ring_azimuths.clear();
    planes.clear();
    ScanLineStream torn(straight.geometry(), test::staggeredOptions());
    torn.onPlane([&planes](const StreamPlane& plane) { planes.push_back(plane); });
    test::addAll(straight, columns, torn, true);
    EXPECT_LT(pointsOnTheRoom(planes, scanner, 1e-3), measured / 2);
  }
}

}  // namespace
}  // namespace epcc
