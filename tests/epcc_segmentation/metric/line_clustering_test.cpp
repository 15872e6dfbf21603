// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1 on exact, noisy, stepped and outlier-ridden profiles (Figs. 11-13).
#include "metric/line_clustering.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace {

using epcc::ClusteredLines;
using epcc::PaperParameters;
using epcc::ScanLine;
using epcc::SensorModel;

constexpr int kSize = 200;

double verticalRay(int row) {
  return (row - 0.5 * (kSize - 1)) / kSize;
}

/// The middle column of a camera that sees the depth profile z(row); depth 0 is a hole.
ScanLine profile(const std::function<double(int)>& z, const SensorModel& sensor) {
  ScanLine line;
  for (int row = 0; row < kSize; ++row) {
    const double depth = z(row);
    if (depth <= 0.0) continue;
    const Eigen::Vector2d t(depth, depth * verticalRay(row));
    const double sigma = sensor.sigmaZ(depth);
    line.samples.push_back({t, t / depth, sigma * sigma, row});
  }
  return line;
}

ClusteredLines cluster(const ScanLine& line, const PaperParameters& parameters = {}) {
  epcc::LineClustering clustering(parameters);
  ClusteredLines result;
  clustering.cluster(line, result);
  return result;
}

/// Depth of the line t1 = offset + slope * t2 seen along the ray of a row.
double slanted(int row, double offset, double slope) {
  return offset / (1.0 - slope * verticalRay(row));
}

const SensorModel kSensor = SensorModel::axial(0.002, 0.0);

TEST(LineClustering, AnExactLineIsOneSegmentThroughAllSamples) {
  const auto segments = cluster(profile([](int row) { return slanted(row, 2.0, 0.4); }, kSensor));
  ASSERT_EQ(segments.segments.size(), 1u);
  const auto& s = segments.segments[0];
  EXPECT_EQ(s.first, 0);
  EXPECT_EQ(s.last, kSize - 1);
  EXPECT_EQ(s.member_end - s.member_begin, kSize);
  EXPECT_NEAR(s.prototype.variance, 0.0, 1e-15);
  // Normal of t1 - 0.4 t2 = 2.
  const Eigen::Vector2d normal = Eigen::Vector2d(1.0, -0.4).normalized();
  EXPECT_NEAR(std::abs(s.prototype.normal.dot(normal)), 1.0, 1e-12);
  EXPECT_NEAR((s.a - Eigen::Vector3d(0.0, s.start.y(), s.start.x())).norm(), 0.0, 1e-12);
}

TEST(LineClustering, TwoSlopesMeetAtTheirCorner) {
  const auto segments =
      cluster(profile([](int row) { return row < 100 ? slanted(row, 2.0, 0.6) : slanted(row, 2.0, -0.6); }, kSensor));
  ASSERT_EQ(segments.segments.size(), 2u);
  EXPECT_NEAR(segments.segments[0].last, 99, 4);
  EXPECT_NEAR(segments.segments[1].first, 100, 4);
}

TEST(LineClustering, AStepSplitsTheLineAtItsPixel) {
  const auto segments = cluster(profile([](int row) { return row < 80 ? 2.0 : 2.1; }, kSensor));
  ASSERT_EQ(segments.segments.size(), 2u);
  EXPECT_EQ(segments.segments[0].last, 79);
  EXPECT_EQ(segments.segments[1].first, 80);
}

TEST(LineClustering, AStepBelowTheNoiseDoesNotSplit) {
  const auto segments = cluster(profile([](int row) { return row < 80 ? 2.0 : 2.001; }, kSensor));
  EXPECT_EQ(segments.segments.size(), 1u);
}

TEST(LineClustering, WhiteSensorNoiseLeavesTheLineWhole) {
  int one_segment = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(0.0, 0.002);
    const auto segments =
        cluster(profile([&](int row) { return slanted(row, 2.0, 0.3) + normal(generator); }, kSensor));
    long members = 0;
    for (const auto& s : segments.segments) members += s.member_end - s.member_begin;
    EXPECT_GT(members, 0.9 * kSize) << "seed " << seed;
    one_segment += segments.segments.size() == 1 ? 1 : 0;
  }
  EXPECT_GE(one_segment, 18);
}

TEST(LineClustering, OutliersAreLeftOutAndDoNotSplit) {
  const auto is_outlier = [](int row) { return row % 17 == 5 || (row >= 60 && row < 65); };
  const auto segments =
      cluster(profile([&](int row) { return is_outlier(row) ? 1.0 + 0.03 * (row % 7) : 2.0; }, kSensor));
  ASSERT_EQ(segments.segments.size(), 1u);
  for (const int row : segments.members) EXPECT_FALSE(is_outlier(row)) << row;
}

TEST(LineClustering, HolesEndNothing) {
  const auto segments = cluster(profile([](int row) { return row >= 50 && row < 120 ? 0.0 : 2.0; }, kSensor));
  ASSERT_EQ(segments.segments.size(), 1u);
  EXPECT_EQ(segments.segments[0].last, kSize - 1);
}

TEST(LineClustering, FewerSamplesThanKMinGiveNoSegment) {
  const auto short_line = [](int count) {
    return profile([count](int row) { return row < count ? 2.0 : 0.0; }, kSensor);
  };
  EXPECT_TRUE(cluster(ScanLine()).segments.empty());
  EXPECT_TRUE(cluster(short_line(7)).segments.empty());
  EXPECT_EQ(cluster(short_line(8)).segments.size(), 1u);
}

TEST(LineClustering, WithoutTheNoiseModelNoisyDataLosesCoverage) {  // Figs. 12, 13
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0.0, 0.002);
  const ScanLine line = profile([&](int) { return 2.0 + normal(generator); }, kSensor);
  PaperParameters without;
  without.expert.lines.use_sensor_noise = false;
  EXPECT_LT(cluster(line, without).members.size(), cluster(line).members.size());
}

TEST(LineClustering, SegmentsKeepTheOrderOfTheScanAndNeverShareAPixel) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(0.5, 4.0);
  for (int trial = 0; trial < 50; ++trial) {
    double level = 1.0;
    const auto segments = cluster(profile(
        [&](int row) {
          if (row % 23 == 0) level = uniform(generator);
          return row % 5 == 0 ? uniform(generator) : level;
        },
        kSensor));
    int last = -1;
    for (const int row : segments.members) {
      ASSERT_GT(row, last);
      last = row;
    }
    for (const auto& s : segments.segments) ASSERT_GE(s.member_end - s.member_begin, 8);
  }
}

TEST(LineClustering, FeedingSampleBySampleGivesTheSameSegments) {
  const ScanLine line = profile([](int row) { return row < 80 ? 2.0 : 2.0 + 0.01 * row; }, kSensor);
  const auto whole = cluster(line);
  epcc::LineClustering clustering{PaperParameters()};
  ClusteredLines stream;
  clustering.begin(stream);
  for (const auto& sample : line.samples) clustering.add(sample);
  clustering.finish();
  ASSERT_EQ(stream.segments.size(), whole.segments.size());
  EXPECT_EQ(stream.members, whole.members);
  for (std::size_t i = 0; i < whole.segments.size(); ++i) EXPECT_EQ(stream.segments[i].start, whole.segments[i].start);
}

TEST(LineClustering, EndpointsLieOnThePrototype) {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal(0.0, 0.002);
  const auto segments = cluster(profile([&](int row) { return slanted(row, 2.0, 0.3) + normal(generator); }, kSensor));
  ASSERT_FALSE(segments.segments.empty());
  for (const auto& s : segments.segments) {
    EXPECT_NEAR(s.prototype.distance(s.start), 0.0, 1e-12);
    EXPECT_NEAR(s.prototype.distance(s.end), 0.0, 1e-12);
  }
}

}  // namespace
