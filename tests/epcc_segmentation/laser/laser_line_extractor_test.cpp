// SPDX-License-Identifier: BSD-3-Clause
// Lines of laser scans: parameters, ends and covariances, gaps, hidden parts, full circles, and what cannot be used.
#include "epcc_segmentation/laser_line_extractor.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/epcc_segmentation/laser/laser_scans.h"

namespace epcc::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const SensorModel kNoise = SensorModel::polynomial(0.0, 0.0, 0.01);

LaserLines linesOf(const LaserScan& scan, const LaserLineParameters& parameters = {}) {
  LaserLineExtractor extractor(kNoise, parameters);
  LaserLines lines;
  EXPECT_TRUE(extractor.extract(scan, lines)) << extractor.error();
  EXPECT_EQ(extractor.status(), Status::Ok);
  EXPECT_EQ(lines.labels.size(), scan.ranges.size());
  return lines;
}

void expectNear(const Vector2& point, double x, double y, double tolerance) {
  EXPECT_NEAR(point.x(), x, tolerance);
  EXPECT_NEAR(point.y(), y, tolerance);
}

TEST(LaserLineExtractor, ARoomHasFourWallsThatMeetInItsCorners) {
  const LaserLines lines = linesOf(scanOf(room(-2.0, 3.0, -1.5, 2.5), 720, 0.0, 0.5 * kDegree, 0.01));
  ASSERT_EQ(lines.lines.size(), 4U);
  EXPECT_GT(std::count_if(lines.labels.begin(), lines.labels.end(), [](int label) { return label > 0; }), 710);
  // In the order of their first beams: the right wall passes the seam and begins last.
  const LaserLine& right = lines.lines[3];
  EXPECT_GT(right.first, right.last);
  EXPECT_NEAR(right.alpha, 0.0, 0.01);
  EXPECT_NEAR(right.rho, 3.0, 0.01);
  EXPECT_NEAR(right.chi_squared, 1.0, 0.5);
  EXPECT_NEAR(std::sqrt(right.variance), 0.01, 0.004);
  EXPECT_TRUE(right.starts_in_corner);
  EXPECT_TRUE(right.ends_in_corner);
  expectNear(right.start, 3.0, -1.5, 0.01);
  expectNear(right.end, 3.0, 2.5, 0.01);
  expectNear(lines.lines[0].start, 3.0, 2.5, 0.01);
  EXPECT_NEAR(lines.lines[0].rho, 2.5, 0.01);
  EXPECT_NEAR(std::abs(lines.lines[1].alpha), std::acos(-1.0), 0.01);
}

TEST(LaserLineExtractor, AScanThatRunsClockwiseIsTheSame) {
  const LaserLines lines = linesOf(scanOf(room(-2.0, 3.0, -1.5, 2.5), 360, 0.3, -kDegree, 0.01));
  ASSERT_EQ(lines.lines.size(), 4U);
  for (const LaserLine& line : lines.lines) EXPECT_TRUE(line.starts_in_corner && line.ends_in_corner);
}

TEST(LaserLineExtractor, PointsAndRangesGiveTheSameLines) {
  const LaserScan scan = scanOf(room(-2.0, 3.0, -1.5, 2.5), 360, -1.0, kDegree, 0.01);
  std::vector<Vector2> points;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i)
    points.push_back(scan.ranges[i] * Vector2(std::cos(scan.angle(i)), std::sin(scan.angle(i))));
  const LaserLines a = linesOf(scan), b = linesOf(LaserScan::fromPoints(points));
  ASSERT_EQ(a.lines.size(), b.lines.size());
  EXPECT_EQ(a.labels, b.labels);
  for (std::size_t k = 0; k < a.lines.size(); ++k) EXPECT_NEAR(a.lines[k].rho, b.lines[k].rho, 1e-9);
}

TEST(LaserLineExtractor, CovarianceIsThatOfTheErrors) {
  double nees = 0.0, ends = 0.0;
  int cut = 0;
  constexpr int kScans = 300;
  for (unsigned seed = 0; seed < kScans; ++seed) {
    const LaserLines lines = linesOf(scanOf({{{2.0, -1.0}, {2.5, 1.5}}}, 180, -90 * kDegree, kDegree, 0.01, seed));
    if (lines.lines.size() != 1) {  // one wall in some thousand is cut by chance
      ++cut;
      continue;
    }
    const LaserLine& line = lines.lines[0];
    const Eigen::Vector2d normal = Eigen::Vector2d(2.5, -0.5).normalized();
    const Eigen::Vector2d error(line.alpha - std::atan2(normal.y(), normal.x()),
                                line.rho - normal.dot(Vector2(2.0, -1.0)));
    nees += error.dot(Eigen::Matrix2d(line.covariance).inverse() * error) / kScans;
    const Eigen::Vector2d end = line.end - Vector2(2.5, 1.5);
    ends += end.dot(Eigen::Matrix2d(line.end_covariance).inverse() * end) < 11.83;
  }
  EXPECT_LE(cut, 1);
  EXPECT_NEAR(nees, 2.0, 0.35);  // 2 with a standard deviation of 2 / sqrt(300)
  EXPECT_GE(ends, 0.96 * kScans);
}

TEST(LaserLineExtractor, ADoorPartsAWallAndASmallOpeningDoesNot) {
  const auto wallWith = [](double gap) {
    return scanOf({{{2.0, -2.0}, {2.0, -0.5 * gap}}, {{2.0, 0.5 * gap}, {2.0, 2.0}}, {{5.0, -4.0}, {5.0, 4.0}}}, 361,
                  -90 * kDegree, 0.5 * kDegree, 0.01);
  };
  const auto onWall = [](const LaserLines& lines) {
    return std::count_if(lines.lines.begin(), lines.lines.end(), [](const LaserLine& l) { return l.rho < 2.5; });
  };
  EXPECT_EQ(onWall(linesOf(wallWith(0.9))), 2);
  EXPECT_EQ(onWall(linesOf(wallWith(0.15))), 1);
  LaserLineParameters wide;
  wide.max_gap = 1.2;
  EXPECT_EQ(onWall(linesOf(wallWith(0.9), wide)), 1);
}

TEST(LaserLineExtractor, AWallBehindABoxIsOneLine) {
  const LaserScan scan =
      scanOf({{{3.0, -3.0}, {3.0, 3.0}}, {{1.5, -0.4}, {1.5, 0.4}}}, 361, -90 * kDegree, 0.5 * kDegree, 0.01);
  const LaserLines joined = linesOf(scan);
  ASSERT_EQ(joined.lines.size(), 2U);
  EXPECT_NEAR(joined.lines[0].length(), 6.0, 0.1);
  EXPECT_NEAR(joined.lines[1].length(), 0.8, 0.1);
  LaserLineParameters pieces;
  pieces.join_hidden = false;
  EXPECT_EQ(linesOf(scan, pieces).lines.size(), 3U);
  pieces = {};
  pieces.max_hidden = 0.5;
  EXPECT_EQ(linesOf(scan, pieces).lines.size(), 3U);
}

TEST(LaserLineExtractor, WallsBehindABoxThatAreNoneOfOneLineStayTwo) {
  const LaserScan scan = scanOf({{{3.0, -3.0}, {3.0, 0.0}}, {{3.1, 0.0}, {3.1, 3.0}}, {{1.5, -0.4}, {1.5, 0.4}}}, 361,
                                -90 * kDegree, 0.5 * kDegree, 0.01);
  EXPECT_EQ(linesOf(scan).lines.size(), 3U);
}

TEST(LaserLineExtractor, WhatIsNoReturnIsSkippedAndEndsNothing) {
  LaserScan scan = scanOf({{{2.0, -2.0}, {2.0, 2.0}}}, 181, -90 * kDegree, kDegree, 0.01);
  scan.range_max = 30.0;
  const double nothing[] = {kNan, std::numeric_limits<double>::infinity(), 0.0, 30.0, -1.0, 31.0, -kNan};
  for (std::size_t i = 0; i < 7; ++i) scan.ranges[66 + 7 * i] = nothing[i];
  const LaserLines lines = linesOf(scan);
  ASSERT_EQ(lines.lines.size(), 1U);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(lines.labels[66 + 7 * i], 0);
}

TEST(LaserLineExtractor, FewPointsAreALineIfTheyAreEnough) {
  const LaserScan scan = scanOf({{{2.0, -0.12}, {2.0, 0.12}}}, 181, -90 * kDegree, kDegree, 0.002);
  EXPECT_TRUE(linesOf(scan).lines.empty());  // seven beams
  LaserLineParameters few;
  few.min_points = 6;
  EXPECT_EQ(linesOf(scan, few).lines.size(), 1U);
}

TEST(LaserLineExtractor, ScansWithoutReturnsHaveNoLines) {
  LaserScan scan;
  scan.angle_increment = kDegree;
  scan.ranges.assign(100, kNan);
  EXPECT_TRUE(linesOf(scan).lines.empty());
  scan.ranges.assign(1, 1.0);
  EXPECT_TRUE(linesOf(scan).lines.empty());
  scan.ranges.assign(360, 1e300);
  EXPECT_TRUE(linesOf(scan).lines.empty());
  scan.ranges.assign(360, 1e-300);
  EXPECT_TRUE(linesOf(scan).lines.empty());
}

TEST(LaserLineExtractor, RangesThatNoLaserMeasuresAreNoReturns) {
  LaserScan scan = scanOf(room(-1.0, 1.0, -1.0, 1.0), 360, 0.0, kDegree);
  const std::size_t lines = linesOf(scan).lines.size();
  for (std::size_t i = 0; i < scan.ranges.size(); i += 7) scan.ranges[i] = i % 2 == 0 ? 2.2e-308 : 1.7e308;
  EXPECT_FALSE(scan.hasReturn(0));
  EXPECT_FALSE(scan.hasReturn(7));
  EXPECT_EQ(linesOf(scan).lines.size(), lines);
}

TEST(LaserLineExtractor, LinesOfAnyRangesAreFinite) {
  std::mt19937_64 random(3);
  for (int scans = 0; scans < 300; ++scans) {
    LaserScan scan = scanOf(room(-1.0, 1.0, -1.0, 1.0), 90, 0.0, kDegree);
    for (double& range : scan.ranges)
      if (random() % 4 == 0) range = std::pow(10.0, static_cast<double>(random() % 600) - 300.0);
    for (const LaserLine& line : linesOf(scan).lines) {
      EXPECT_TRUE(line.start.allFinite() && line.end.allFinite() && line.covariance.allFinite());
      EXPECT_TRUE(line.rho > 0.0 && line.chi_squared >= 0.0);
    }
  }
}

// Eight returns at a millimetre and one behind them make a line that passes the sensor at a hair's breadth: the terms
// of its covariance cancel.
TEST(LaserLineExtractor, CovariancesAreSymmetricToTheLastBit) {
  std::vector<LaserScan> scans = {scanOf(room(-2.0, 3.0, -1.5, 2.5), 720, 0.0, 0.5 * kDegree, 0.01)};
  for (const double angle : {-1.21, -0.5, 0.3}) {
    LaserScan scan;
    scan.ranges.assign(9, 0.001);
    scan.ranges[0] = angle > 0.0 ? 0.5 : 0.1;
    scan.angle_min = angle;
    scan.angle_increment = 0.01;
    scans.push_back(scan);
  }
  for (const LaserScan& scan : scans) {
    const LaserLines lines = linesOf(scan);
    EXPECT_FALSE(lines.lines.empty());
    for (const LaserLine& line : lines.lines)
      for (const Matrix2& covariance : {line.covariance, line.start_covariance, line.end_covariance})
        EXPECT_EQ(covariance(0, 1), covariance(1, 0));
  }
}

TEST(LaserLineExtractor, SaysWhatCannotBeUsed) {
  LaserLineExtractor extractor(kNoise);
  LaserLines lines;
  LaserScan scan;
  EXPECT_FALSE(extractor.extract(scan, lines));
  EXPECT_EQ(extractor.status(), Status::EmptyCloud);
  scan.ranges.assign(10, 1.0);
  EXPECT_FALSE(extractor.extract(scan, lines));
  EXPECT_EQ(extractor.error(), "the angle increment is zero");
  scan.angle_increment = kNan;
  EXPECT_FALSE(extractor.extract(scan, lines));
  scan.angles.assign(9, 0.0);
  EXPECT_FALSE(extractor.extract(scan, lines));
  EXPECT_EQ(extractor.status(), Status::SizeMismatch);
  EXPECT_EQ(extractor.error(), "10 ranges and 9 angles");
  scan.angles.assign(10, kNan);
  EXPECT_FALSE(extractor.extract(scan, lines));
  scan.angles.assign(10, 0.0);  // ten times the same beam: no line, but no error
  EXPECT_TRUE(extractor.extract(scan, lines));
  EXPECT_TRUE(lines.lines.empty());
}

TEST(LaserLineExtractor, ParametersHaveRanges) {
  LaserLineParameters parameters;
  EXPECT_EQ(parameters.validate(), "");
  parameters.k_max = kNan;
  EXPECT_EQ(parameters.validate(), "k_max: must be 0.5 to 10");
  parameters = {};
  parameters.min_points = 4;
  EXPECT_EQ(parameters.validate(), "min_points: must be 5 to 1000");
  parameters = {};
  parameters.max_gap = -0.1;
  EXPECT_EQ(parameters.validate(), "max_gap: must be 0 to 1000 m");
  LaserLineExtractor extractor(kNoise, parameters);
  LaserLines lines;
  LaserScan scan = scanOf(room(-1.0, 1.0, -1.0, 1.0), 360, 0.0, kDegree);
  EXPECT_FALSE(extractor.extract(scan, lines));
  EXPECT_EQ(extractor.status(), Status::InvalidParameters);
}

TEST(LaserScan, KnowsAFullCircle) {
  LaserScan scan;
  scan.angle_increment = kDegree;
  scan.ranges.assign(360, 1.0);
  EXPECT_TRUE(scan.isFullCircle());
  scan.ranges.assign(361, 1.0);
  EXPECT_TRUE(scan.isFullCircle());
  scan.ranges.assign(270, 1.0);
  EXPECT_FALSE(scan.isFullCircle());
}

}  // namespace
}  // namespace epcc::test
