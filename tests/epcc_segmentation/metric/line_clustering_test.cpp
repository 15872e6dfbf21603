// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1 on exact, noisy, stepped and outlier-ridden profiles (Figs. 11-13).
#include "metric/line_clustering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "metric/clustered_line.h"

namespace {

using epcc::ClusteringRule;
using epcc::LineRecord;
using epcc::PaperParameters;
using epcc::SensorModel;

constexpr int kSize = 200;
constexpr int kLine = 5;  // of a strip; the others are not measured

double verticalRay(int row) {
  return (row - 0.5 * (kSize - 1)) / kSize;
}

/// Depths of the middle column of a camera that sees the depth profile z(row); depth 0 is a hole.
using Profile = std::array<float, kSize>;
Profile profile(const std::function<double(int)>& z) {
  Profile result{};
  for (int row = 0; row < kSize; ++row) result[static_cast<std::size_t>(row)] = static_cast<float>(z(row));
  return result;
}

struct Segments {
  std::vector<LineRecord> segments;
  std::vector<int> members;  // rows that have a number
  std::vector<int> places;   // their segments
  int countOf(std::size_t segment) const {
    return static_cast<int>(std::count(places.begin(), places.end(), static_cast<int>(segment)));
  }
};

Segments cluster(const Profile& depth, const SensorModel& sensor, const PaperParameters& parameters = {}) {
  std::vector<float> z(kSize * epcc::kStripLines, 0.0f);
  for (int row = 0; row < kSize; ++row)
    z[static_cast<std::size_t>(row * epcc::kStripLines + kLine)] = depth[static_cast<std::size_t>(row)];
  const std::vector<float> secant(epcc::kStripLines, 1.0f);
  std::vector<float> along;
  for (int row = 0; row < kSize; ++row) along.push_back(static_cast<float>(verticalRay(row)));
  epcc::ScanStrip strip;
  strip.height = kSize;
  strip.stride = epcc::kStripLines;
  strip.z = z.data();
  strip.secant = secant.data();
  strip.along = along.data();
  constexpr int kCapacity = kSize;
  std::vector<LineRecord> records(kCapacity * epcc::kStripLines);
  std::vector<std::int32_t> numbers(z.size());
  epcc::StripSegments found;
  found.capacity = kCapacity;
  found.records = records.data();
  found.numbers = numbers.data();
  found.number_stride = epcc::kStripLines;
  epcc::LineWorkspace workspace;
  epcc::clusterLines(strip, ClusteringRule(parameters, sensor), workspace, found);
  Segments result;
  for (int k = 0; k < found.count[kLine]; ++k)
    result.segments.push_back(records[static_cast<std::size_t>(kLine * kCapacity + k)]);
  for (int row = 0; row < kSize; ++row) {
    const std::int32_t number = numbers[static_cast<std::size_t>(row * epcc::kStripLines + kLine)];
    if (number == 0) continue;
    result.members.push_back(row);
    result.places.push_back((number - found.first_number - kLine) / epcc::kStripLines);
  }
  return result;
}

/// Depth of the line t1 = offset + slope * t2 seen along the ray of a row.
double slanted(int row, double offset, double slope) {
  return offset / (1.0 - slope * verticalRay(row));
}

const SensorModel kProfileSensor = SensorModel::axial(0.002, 0.0);

TEST(LineClustering, AnExactLineIsOneSegmentThroughAllSamples) {
  const auto segments = cluster(profile([](int row) { return slanted(row, 2.0, 0.4); }), kProfileSensor);
  ASSERT_EQ(segments.segments.size(), 1u);
  const auto& s = segments.segments[0];
  EXPECT_EQ(s.first, 0);
  EXPECT_EQ(s.last, kSize - 1);
  EXPECT_EQ(segments.countOf(0), kSize);
  EXPECT_EQ(s.n, static_cast<float>(kSize));
  EXPECT_NEAR(s.residuals / (s.n - 1.0f), 0.0f, 1e-13f);  // depths are rounded to 1e-7 of themselves
  // Normal of t1 - 0.4 t2 = 2.
  const Eigen::Vector2d normal = Eigen::Vector2d(1.0, -0.4).normalized();
  EXPECT_NEAR(std::abs(Eigen::Vector2d(s.normal[0], s.normal[1]).normalized().dot(normal)), 1.0, 1e-12);
  EXPECT_EQ(s.first_sample[1], s.first_sample[0] * static_cast<float>(verticalRay(0)));
  EXPECT_EQ(s.last_sample[1], s.last_sample[0] * static_cast<float>(verticalRay(kSize - 1)));
}

TEST(LineClustering, TwoSlopesMeetAtTheirCorner) {
  const auto segments = cluster(
      profile([](int row) { return row < 100 ? slanted(row, 2.0, 0.6) : slanted(row, 2.0, -0.6); }), kProfileSensor);
  ASSERT_EQ(segments.segments.size(), 2u);
  EXPECT_NEAR(segments.segments[0].last, 99, 4);
  EXPECT_NEAR(segments.segments[1].first, 100, 4);
}

TEST(LineClustering, AStepSplitsTheLineAtItsPixel) {
  const auto segments = cluster(profile([](int row) { return row < 80 ? 2.0 : 2.1; }), kProfileSensor);
  ASSERT_EQ(segments.segments.size(), 2u);
  EXPECT_EQ(segments.segments[0].last, 79);
  EXPECT_EQ(segments.segments[1].first, 80);
}

TEST(LineClustering, AStepBelowTheNoiseDoesNotSplit) {
  const auto segments = cluster(profile([](int row) { return row < 80 ? 2.0 : 2.001; }), kProfileSensor);
  EXPECT_EQ(segments.segments.size(), 1u);
}

TEST(LineClustering, WhiteSensorNoiseLeavesTheLineWhole) {
  int one_segment = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(0.0, 0.002);
    const auto segments =
        cluster(profile([&](int row) { return slanted(row, 2.0, 0.3) + normal(generator); }), kProfileSensor);
    long members = 0;
    for (const auto& s : segments.segments) members += static_cast<long>(s.n);
    EXPECT_GT(members, 0.9 * kSize) << "seed " << seed;
    one_segment += segments.segments.size() == 1 ? 1 : 0;
  }
  EXPECT_GE(one_segment, 18);
}

TEST(LineClustering, OutliersAreLeftOutAndDoNotSplit) {
  const auto is_outlier = [](int row) { return row % 17 == 5 || (row >= 60 && row < 65); };
  const auto segments =
      cluster(profile([&](int row) { return is_outlier(row) ? 1.0 + 0.03 * (row % 7) : 2.0; }), kProfileSensor);
  ASSERT_EQ(segments.segments.size(), 1u);
  for (const int row : segments.members) EXPECT_FALSE(is_outlier(row)) << row;
}

TEST(LineClustering, HolesEndNothing) {
  const auto segments = cluster(profile([](int row) { return row >= 50 && row < 120 ? 0.0 : 2.0; }), kProfileSensor);
  ASSERT_EQ(segments.segments.size(), 1u);
  EXPECT_EQ(segments.segments[0].last, kSize - 1);
}

TEST(LineClustering, FewerSamplesThanKMinGiveNoSegment) {
  const auto short_line = [](int count) { return profile([count](int row) { return row < count ? 2.0 : 0.0; }); };
  EXPECT_TRUE(cluster(Profile{}, kProfileSensor).segments.empty());
  EXPECT_TRUE(cluster(short_line(7), kProfileSensor).segments.empty());
  EXPECT_EQ(cluster(short_line(8), kProfileSensor).segments.size(), 1u);
}

TEST(LineClustering, WithoutTheNoiseModelNoisyDataLosesCoverage) {  // Figs. 12, 13
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0.0, 0.002);
  const Profile line = profile([&](int) { return 2.0 + normal(generator); });
  PaperParameters without;
  without.expert.lines.use_sensor_noise = false;
  EXPECT_LT(cluster(line, kProfileSensor, without).members.size(), cluster(line, kProfileSensor).members.size());
}

TEST(LineClustering, SegmentsKeepTheOrderOfTheScanAndNeverShareAPixel) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(0.5, 4.0);
  for (int trial = 0; trial < 50; ++trial) {
    double level = 1.0;
    const auto segments = cluster(profile([&](int row) {
                                    if (row % 23 == 0) level = uniform(generator);
                                    return row % 5 == 0 ? uniform(generator) : level;
                                  }),
                                  kProfileSensor);
    int last = -1;
    for (const auto& segment : segments.segments) {
      ASSERT_GT(segment.first, last);
      last = segment.last;
    }
    ASSERT_TRUE(std::is_sorted(segments.places.begin(), segments.places.end()));
    for (std::size_t k = 0; k < segments.segments.size(); ++k) {
      ASSERT_GE(segments.segments[k].n, 8.0f);
      ASSERT_EQ(segments.countOf(k), static_cast<int>(segments.segments[k].n));
    }
  }
}

TEST(LineClustering, StatisticsAndResidualVarianceFollowTheirEquations) {
  std::mt19937 generator(7);
  std::normal_distribution<double> normal(0.0, 0.002);
  const Profile depth = profile([&](int row) { return slanted(row, 2.0, 0.3) + normal(generator); });
  const auto found = cluster(depth, kProfileSensor);
  ASSERT_FALSE(found.segments.empty());
  const LineRecord& segment = found.segments[0];
  // Eqs. 11 to 13 as printed, in double precision; the first k_min samples are fitted.
  epcc::LinePrototype prototype;
  const auto turn = [&] { prototype.normal = epcc::smallestEigenvector(prototype.statistics.covariance); };
  for (std::size_t i = 0; i < found.members.size() && found.places[i] == 0; ++i) {
    const int row = found.members[i];
    const double z = static_cast<double>(depth[static_cast<std::size_t>(row)]);
    const Eigen::Vector2d t(z, z * verticalRay(row));
    const double d = prototype.distance(t);
    prototype.statistics.add(t);
    const double n = prototype.statistics.n;
    if (n >= 8) turn();
    if (n == 8) prototype.resetVariance();
    if (n > 8) prototype.variance = (n - 2.0) / (n - 1.0) * prototype.variance + d * d / n;
  }
  const double n = prototype.statistics.n;
  ASSERT_EQ(segment.n, static_cast<float>(n));
  EXPECT_GT(n, 100.0);
  EXPECT_NEAR(segment.mean[0], prototype.statistics.mean.x(), 2e-6);
  EXPECT_NEAR(segment.mean[1], prototype.statistics.mean.y(), 2e-6);
  const Eigen::Matrix2d& covariance = prototype.statistics.covariance;
  EXPECT_NEAR(segment.scatter[0] / (n - 1.0), covariance(0, 0), 1e-5 * covariance(1, 1));
  EXPECT_NEAR(segment.scatter[1] / (n - 1.0), covariance(1, 1), 1e-5 * covariance(1, 1));
  EXPECT_NEAR(segment.scatter[2] / (n - 1.0), covariance(0, 1), 1e-5 * covariance(1, 1));
  EXPECT_NEAR(segment.residuals / (n - 1.0), prototype.variance, 1e-3 * prototype.variance);
  // The recursion of the residuals ends near the noise it was fed.
  EXPECT_NEAR(std::sqrt(prototype.variance), 0.002, 0.0006);
}

}  // namespace
