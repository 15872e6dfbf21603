// SPDX-License-Identifier: BSD-3-Clause
// A scanner whose rings look at different azimuths: its stream is the cloud whose columns have one azimuth.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "epcc_segmentation/vector_unit.h"
#include "tests/support/spinning_scanner.h"
#include "tests/support/streamed_frame.h"

namespace epcc {
namespace {

const SensorModel kSensor = SensorModel::axial(0.004, 0.0);

StreamOptions optionsOf(int lines_at_once = 32) {
  StreamOptions options;
  options.sensor = kSensor;
  options.lines_at_once = lines_at_once;
  return options;
}

/// Four offsets over and over, as many scanners have, in steps of the azimuth; `part` of a step more on every other.
test::SpinningScanner staggeredScanner(double noise = 0.004, double part = 0.3) {
  test::SpinningScanner scanner;
  scanner.noise = noise;
  const double steps[] = {6.0, 2.0, -2.0, -7.0};
  for (int ring = 0; ring < scanner.rings; ++ring)
    scanner.ring_azimuths.push_back((steps[ring % 4] + (ring % 2 == 0 ? part : -part)) * scanner.azimuthStep());
  return scanner;
}

std::vector<std::vector<float>> columnsOf(const test::SpinningScanner& scanner, int columns, unsigned seed = 3) {
  std::mt19937 random(seed);
  std::vector<std::vector<float>> result;
  for (int column = 0; column < columns; ++column) result.push_back(scanner.ranges(column, random));
  return result;
}

/// The shifts of a geometry.
struct Shifts {
  explicit Shifts(const StreamGeometry& geometry) {
    for (int ring = 0; ring < geometry.height(); ++ring) of.push_back(geometry.ringShift(ring));
    least = *std::min_element(of.begin(), of.end());
    most = *std::max_element(of.begin(), of.end());
  }
  std::vector<int> of;
  int least = 0, most = 0;
};

/// Ring `ring` of a column as a point: x forward, y left, z up; NaN where nothing is measured.
void pointOf(const test::SpinningScanner& scanner, int column, std::size_t ring, float range, float* xyz) {
  const double elevation = scanner.elevations()[ring];
  const double azimuth = scanner.azimuth(column) + scanner.ringAzimuth(ring);
  xyz[0] = static_cast<float>(range * std::cos(elevation) * std::cos(azimuth));
  xyz[1] = static_cast<float>(range * std::cos(elevation) * std::sin(azimuth));
  xyz[2] = static_cast<float>(range * std::sin(elevation));
}

/// The columns as a cloud, row by row: as they came, or (`aligned`) by scan lines, which are more.
std::vector<float> cloudOf(const test::SpinningScanner& scanner, const std::vector<std::vector<float>>& columns,
                           bool aligned) {
  const Shifts shifts(scanner.geometry());
  const int count = static_cast<int>(columns.size());
  const int width = aligned ? count + shifts.most - shifts.least : count;
  std::vector<float> xyz(static_cast<std::size_t>(3 * scanner.rings * width), NAN);
  for (int ring = 0; ring < scanner.rings; ++ring)
    for (int column = 0; column < count; ++column) {
      const auto r = static_cast<std::size_t>(ring);
      const int line = aligned ? column - shifts.of[r] + shifts.most : column;
      pointOf(scanner, column, r, columns[static_cast<std::size_t>(column)][r], xyz.data() + 3 * (ring * width + line));
    }
  return xyz;
}

void addAll(const test::SpinningScanner& scanner, const std::vector<std::vector<float>>& columns,
            ScanLineStream& stream, bool at_azimuths = false) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto column = static_cast<std::int64_t>(i);
    const double azimuth = scanner.azimuth(column);
    ASSERT_TRUE(at_azimuths ? stream.addColumnAt(azimuth, columns[i].data())
                            : stream.addColumn(column, azimuth, columns[i].data()))
        << stream.error();
  }
  ASSERT_TRUE(stream.finish()) << stream.error();
}

TEST(StaggeredRings, AreTheAlignedCloudSegmentedWholeOnEveryVectorUnit) {
  const std::string before = vectorUnit();
  const test::SpinningScanner scanner = staggeredScanner();
  const Shifts shifts(scanner.geometry());
  const auto columns = columnsOf(scanner, scanner.columns);
  const int lines = scanner.columns + shifts.most - shifts.least;
  const std::vector<float> xyz = cloudOf(scanner, columns, true);
  for (const std::string& unit : vectorUnits()) {
    ASSERT_TRUE(setVectorUnit(unit));
    PlaneExtractor extractor(test::wholeFrameParameters({}), kSensor);
    PlaneSegmentation whole;
    const auto cloud = DepthFrame::fromPoints(xyz.data(), 3, lines, scanner.rings, Projection::Spherical);
    ASSERT_TRUE(extractor.extract(cloud, whole)) << extractor.error();
    ASSERT_GE(whole.planes.size(), 5u);
    for (const bool at_azimuths : {false, true}) {
      SCOPED_TRACE(unit + (at_azimuths ? ", at azimuths" : ", by index"));
      ScanLineStream stream(scanner.geometry(), optionsOf(at_azimuths ? 32 : 5));
      test::StreamedFrame streamed(stream, lines, scanner.rings, -shifts.most);
      addAll(scanner, columns, stream, at_azimuths);
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
  const test::SpinningScanner scanner = staggeredScanner();
  const Shifts shifts(scanner.geometry());
  const auto columns = columnsOf(scanner, scanner.columns / 2);
  const int width = scanner.columns / 2;
  const std::vector<float> xyz = cloudOf(scanner, columns, false);
  CloudGeometry geometry;
  geometry.status = Status::Ok;
  geometry.is_plain = false;
  geometry.projection = Projection::Spherical;
  geometry.grid.margin = shifts.most - shifts.least;
  for (const int shift : shifts.of) geometry.grid.ring_shift.push_back(shift - shifts.most);
  PlaneExtractor extractor(test::wholeFrameParameters({}), kSensor);
  PlaneSegmentation whole;
  ASSERT_TRUE(extractor.extract(DepthFrame::fromPoints(xyz.data(), 3, width, scanner.rings, geometry), whole));
  ASSERT_GE(whole.planes.size(), 3u);
  ScanLineStream stream(scanner.geometry(), optionsOf());
  test::StreamedFrame streamed(stream, width + geometry.grid.margin, scanner.rings, -shifts.most);
  addAll(scanner, columns, stream);

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
  const test::SpinningScanner scanner = staggeredScanner(0.0, 0.0);
  const Shifts shifts(scanner.geometry());
  EXPECT_EQ(shifts.of[0], -6) << "its ray is six columns ahead";
  EXPECT_EQ(shifts.of[3], 7);
  const auto columns = columnsOf(scanner, scanner.columns / 2);
  const std::vector<float> xyz = cloudOf(scanner, columns, false);
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
    test::SpinningScanner scanner = staggeredScanner(0.0);
    scanner.heading = heading;
    const auto columns = columnsOf(scanner, 2 * scanner.columns);
    std::size_t measured = 0;
    for (const auto& column : columns)
      for (const float range : column) measured += range > 0.0f ? 1 : 0;
    std::vector<StreamPlane> planes;
    ScanLineStream stream(scanner.geometry(), optionsOf());
    stream.onPlane([&planes](const StreamPlane& plane) { planes.push_back(plane); });
    addAll(scanner, columns, stream, true);
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
    ScanLineStream torn(straight.geometry(), optionsOf());
    torn.onPlane([&planes](const StreamPlane& plane) { planes.push_back(plane); });
    addAll(straight, columns, torn, true);
    EXPECT_LT(pointsOnTheRoom(planes, scanner, 1e-3), measured / 2);
  }
}

TEST(StaggeredRings, OfOffsetsBelowHalfAStepNeedNoOtherColumn) {
  test::SpinningScanner scanner = staggeredScanner();
  for (double& azimuth : scanner.ring_azimuths) azimuth = std::copysign(0.3, azimuth) * scanner.azimuthStep();
  const Shifts shifts(scanner.geometry());
  EXPECT_EQ(shifts.least, 0);
  EXPECT_EQ(shifts.most, 0);
  const auto columns = columnsOf(scanner, scanner.columns);
  const std::vector<float> xyz = cloudOf(scanner, columns, true);
  PlaneExtractor extractor(test::wholeFrameParameters({}), kSensor);
  PlaneSegmentation whole;
  const auto cloud = DepthFrame::fromPoints(xyz.data(), 3, scanner.columns, scanner.rings, Projection::Spherical);
  ASSERT_TRUE(extractor.extract(cloud, whole));
  ScanLineStream stream(scanner.geometry(), optionsOf());
  test::StreamedFrame streamed(stream, scanner.columns, scanner.rings);
  addAll(scanner, columns, stream);
  test::expectTheFrame(streamed, whole);
}

// All rings on one side: no scan line has its own column among those it is made of.
TEST(StaggeredRings, MayAllBeOnOneSideAndTurnEitherWay) {
  test::SpinningScanner scanner = staggeredScanner(0.0);
  for (double& azimuth : scanner.ring_azimuths) azimuth += 12.0 * scanner.azimuthStep();
  ASSERT_LT(Shifts(scanner.geometry()).most, 0);
  const auto columns = columnsOf(scanner, scanner.columns);
  std::vector<StreamPlane> planes[2];
  std::vector<double> azimuths;
  ScanLineStream clockwise(scanner.geometry(), optionsOf());
  clockwise.onPlane([&](const StreamPlane& plane) { planes[0].push_back(plane); });
  clockwise.onLine([&](const LabelledLine& line) {
    EXPECT_NEAR(std::remainder(line.azimuth - scanner.azimuth(line.index), 2.0 * M_PI), 0.0, 1e-9) << line.index;
  });
  addAll(scanner, columns, clockwise);
  // A mirrored scanner turns counter-clockwise, in a mirrored room.
  std::vector<double> mirrored = scanner.ring_azimuths;
  for (double& azimuth : mirrored) azimuth = -azimuth;
  ScanLineStream other(StreamGeometry::scanner(scanner.elevations(), -scanner.azimuthStep(), mirrored), optionsOf());
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

TEST(StaggeredRings, OfLostColumnsAreNotMeasuredInTheirScanLines) {
  const test::SpinningScanner scanner = staggeredScanner();
  const Shifts shifts(scanner.geometry());
  const int lines = scanner.columns + shifts.most - shifts.least;
  auto columns = columnsOf(scanner, scanner.columns);
  // Some, more than look_back, and more than the rings are apart.
  const auto is_lost = [](int c) { return c == 100 || (c >= 200 && c < 207) || (c >= 400 && c < 440); };
  ScanLineStream stream(scanner.geometry(), optionsOf(7));
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
  const std::vector<float> xyz = cloudOf(scanner, columns, true);
  PlaneExtractor extractor(test::wholeFrameParameters({}), kSensor);
  PlaneSegmentation whole;
  ASSERT_TRUE(
      extractor.extract(DepthFrame::fromPoints(xyz.data(), 3, lines, scanner.rings, Projection::Spherical), whole));
  test::expectTheFrame(streamed, whole);
}

TEST(StaggeredRings, GoOnOverTheSeamAndBeginAnewAfterFinishAndReset) {
  const test::SpinningScanner scanner = staggeredScanner();
  const auto columns = columnsOf(scanner, scanner.columns);
  ScanLineStream stream(scanner.geometry(), optionsOf());
  std::size_t counts[3] = {};
  for (std::size_t& count : counts) {
    stream.onPlane([&count](const StreamPlane&) { ++count; });
    addAll(scanner, columns, stream);
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

TEST(StaggeredRings, HaveTheirSensorMeasured) {
  const test::SpinningScanner scanner = staggeredScanner();
  StreamOptions options;
  options.measured_lines = 400;
  ScanLineStream stream(scanner.geometry(), options);
  std::size_t planes = 0;
  stream.onPlane([&planes](const StreamPlane&) { ++planes; });
  addAll(scanner, columnsOf(scanner, scanner.columns), stream);
  EXPECT_FALSE(stream.isMeasuring());
  EXPECT_GT(stream.measuredBlocks(), 10u);
  EXPECT_NEAR(stream.sensor().sigmaZ(4.0), 0.004, 0.002);
  EXPECT_GE(planes, 5u);
}

TEST(StaggeredRings, ThatCannotBeSaySo) {
  const std::vector<double> elevations{0.2, 0.1, 0.0};
  const auto problem = [&](const std::vector<double>& azimuths, double step = 0.01) {
    const StreamGeometry geometry = StreamGeometry::scanner(elevations, step, azimuths);
    ScanLineStream stream(geometry, optionsOf());
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
