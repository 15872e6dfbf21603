// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 2 step by step on made segments.
#include "metric/plane_clustering.h"

#include <gtest/gtest.h>

namespace {

using epcc::ClusteredLine;
using epcc::EndpointWeight;
using epcc::PaperParameters;
using epcc::PlaneClustering;
using epcc::PlaneCriterion;
using epcc::Projection;
using epcc::SensorModel;

/// A vertical segment of the plane z = depth at the lateral position x.
ClusteredLine vertical(double x, double depth, double low = -0.5, double high = 0.5) {
  ClusteredLine segment;
  segment.a = {x, low, depth};
  segment.b = {x, high, depth};
  return segment;
}

class PlaneClusteringTest : public ::testing::Test {
 protected:
  PlaneClusteringTest() { parameters_.min_segments = 1; }
  PlaneClustering make() const {
    PlaneClustering clustering(parameters_, SensorModel::axial(0.002, 0.0));
    clustering.begin(Projection::Perspective);
    return clustering;
  }
  PaperParameters parameters_;
};

TEST_F(PlaneClusteringTest, CoplanarSegmentsBecomeOnePlane) {
  auto clustering = make();
  for (int i = 0; i < 20; ++i) clustering.addLine({vertical(0.01 * i, 2.0)});
  clustering.finish();
  for (const int label : clustering.labels()) EXPECT_EQ(label, 0);
  ASSERT_EQ(clustering.planes().size(), 1u);
  EXPECT_NEAR(std::abs(clustering.planes()[0].normal.z()), 1.0, 1e-9);
  EXPECT_EQ(clustering.planes()[0].segments, 20);
}

TEST_F(PlaneClusteringTest, PlanesFewerThanMinSegmentsAreDropped) {
  parameters_.min_segments = 15;
  for (const int count : {14, 15}) {
    auto clustering = make();
    for (int i = 0; i < count; ++i) clustering.addLine({vertical(0.01 * i, 2.0)});
    clustering.finish();
    for (const int label : clustering.labels()) EXPECT_EQ(label, count < 15 ? PlaneClustering::kUnlabelled : 0);
  }
}

TEST_F(PlaneClusteringTest, ALineWithoutSegmentsDoesNotEndASurface) {
  for (const int empty : {1, 3, 4}) {
    auto clustering = make();
    for (int i = 0; i < 10; ++i) clustering.addLine({vertical(0.01 * i, 2.0)});
    for (int i = 0; i < empty; ++i) clustering.addLine({});
    clustering.addLine({vertical(0.15, 2.0)});
    clustering.finish();
    // Look-back 4: three empty lines are bridged, four are not.
    EXPECT_EQ(clustering.labels().back(), empty <= 3 ? 0 : PlaneClustering::kUnlabelled) << empty;
  }
}

TEST_F(PlaneClusteringTest, GapBeyondD1PlusSigmaSeparatesCoplanarSegments) {
  const double reach = parameters_.max_gap + 0.002;
  for (const double gap : {reach - 0.001, reach + 0.001}) {
    auto clustering = make();
    for (int i = 0; i < 10; ++i) clustering.addLine({vertical(0.01 * i, 2.0)});
    clustering.addLine({vertical(0.09 + gap, 2.0)});
    clustering.finish();
    EXPECT_EQ(clustering.labels().back(), gap < reach ? 0 : PlaneClustering::kUnlabelled) << gap;
  }
}

TEST_F(PlaneClusteringTest, AStepBeyondTheNoiseStartsItsOwnPlane) {
  auto clustering = make();
  for (int i = 0; i < 20; ++i) clustering.addLine({vertical(0.01 * i, i < 10 ? 2.0 : 2.05)});
  clustering.finish();
  for (int i = 0; i < 20; ++i) EXPECT_EQ(clustering.labels()[i], i < 10 ? 0 : 1) << i;
}

TEST_F(PlaneClusteringTest, SegmentsOfDifferentDirectionStartNothing) {
  auto clustering = make();
  ClusteredLine tilted = vertical(0.01, 2.0);
  tilted.b.x() += std::tan(25.0 * M_PI / 180.0);  // 25 degrees within the plane; the limit is 20
  clustering.addLine({vertical(0.0, 2.0)});
  clustering.addLine({tilted});
  EXPECT_TRUE(clustering.planes().empty());
}

TEST_F(PlaneClusteringTest, UnlabelledSegmentsOlderThanTwoLinesAreOutliers) {
  for (const int empty : {1, 2}) {
    auto clustering = make();
    clustering.addLine({vertical(0.0, 2.0)});
    for (int i = 0; i < empty; ++i) clustering.addLine({});
    clustering.addLine({vertical(0.03, 2.0)});
    EXPECT_EQ(clustering.planes().size(), empty == 1 ? 1u : 0u) << empty;
  }
}

TEST_F(PlaneClusteringTest, TheMostCoplanarOfTwoPartnersStartsThePlane) {
  auto clustering = make();
  ClusteredLine tilted = vertical(0.0, 2.0, -0.5, 0.0);
  tilted.b.z() += 0.002;
  clustering.addLine({tilted, vertical(0.0, 2.0, 0.01, 0.5)});
  clustering.addLine({vertical(0.01, 2.0, -0.2, 0.2)});
  EXPECT_EQ(clustering.labels(), (std::vector<int>{PlaneClustering::kUnlabelled, 0, 0}));
}

TEST_F(PlaneClusteringTest, TheFirstOfTwoEqualPartnersStartsThePlane) {
  auto clustering = make();
  clustering.addLine({vertical(0.0, 2.0, -0.5, 0.0), vertical(0.0, 2.0, 0.01, 0.5)});
  clustering.addLine({vertical(0.01, 2.0, -0.2, 0.2)});
  EXPECT_EQ(clustering.labels(), (std::vector<int>{0, PlaneClustering::kUnlabelled, 0}));
}

TEST_F(PlaneClusteringTest, ASurfaceThatForksGoesOnOnBothSides) {
  auto clustering = make();
  clustering.addLine({vertical(-0.005, 2.0)});
  clustering.addLine({vertical(0.005, 2.0)});
  for (int i = 1; i <= 30; ++i) clustering.addLine({vertical(-0.01 * i, 2.0), vertical(0.01 * i, 2.0)});
  for (const int label : clustering.labels()) EXPECT_EQ(label, 0);
}

TEST_F(PlaneClusteringTest, TheBestOfTwoFittingPlanesWins) {
  auto clustering = make();
  for (int i = 0; i < 10; ++i)
    clustering.addLine({vertical(0.01 * i, 2.0, -0.5, 0.0), vertical(0.01 * i, 2.008, 0.01, 0.5)});
  ASSERT_EQ(clustering.planes().size(), 2u);
  clustering.addLine({vertical(0.1, 2.0045, -0.2, 0.2)});
  EXPECT_EQ(clustering.labels().back(), 1);
}

TEST_F(PlaneClusteringTest, TheFourCriteriaOfTable2DifferByTheirVariances) {
  // An offset of 5 mm: inside 3 sigma_z = 6 mm, or inside sigma_seg = 4 mm, but not inside sigma_j = 0.
  const auto joins = [this](PlaneCriterion criterion, double segment_sigma) {
    parameters_.criterion = criterion;
    auto clustering = make();
    for (int i = 0; i < 10; ++i) clustering.addLine({vertical(0.01 * i, 2.0)});
    ClusteredLine next = vertical(0.1, 2.005);
    next.prototype.variance = segment_sigma * segment_sigma;
    clustering.addLine({next});
    return clustering.labels().back() == 0;
  };
  EXPECT_TRUE(joins(PlaneCriterion::PrototypeSensorSegment, 0.0));
  EXPECT_TRUE(joins(PlaneCriterion::PrototypeSensor, 0.0));
  EXPECT_FALSE(joins(PlaneCriterion::PrototypeSegment, 0.0));
  EXPECT_TRUE(joins(PlaneCriterion::PrototypeSegment, 0.004));
  EXPECT_FALSE(joins(PlaneCriterion::Prototype, 0.004));
}

/// The unit square at z = 2: normal z, no thickness.
epcc::PlanePrototype unitSquare() {
  epcc::PlanePrototype prototype;
  for (const auto& p :
       {Eigen::Vector3d(0, 0, 2), Eigen::Vector3d(1, 0, 2), Eigen::Vector3d(0, 1, 2), Eigen::Vector3d(1, 1, 2)})
    prototype.statistics.add(p);
  prototype.refit();
  return prototype;
}

TEST(PlanePrototype, TheFirstDistanceIsItsOwnMean) {
  epcc::PlanePrototype prototype = unitSquare();
  prototype.add({0.5, 0.5, 2.3}, EndpointWeight::Printed);
  EXPECT_NEAR(prototype.mean_distance, 0.3, 1e-12);
  EXPECT_NEAR(prototype.statistics.mean.z(), 2.06, 1e-12);  // (4 * 2 + 2.3) / 5: no weight in Eq. 12
  // Eq. 25 with k = 5: 3/4 * 0 + w/5 * 0.3^2, w = exp(-1).
  EXPECT_NEAR(prototype.statistics.covariance(2, 2), 0.36787944117144233 * 0.09 / 5.0, 1e-12);
}

TEST(PlanePrototype, EveryWeightAsWorkedByHand) {
  // Distances 0.1, 0.1 and then 0.4: the mean with the new one is 0.2, the ratio d/mu is 2.
  const std::pair<EndpointWeight, double> forms[] = {{EndpointWeight::Printed, 0.01831563888873418},     // exp(-4)
                                                     {EndpointWeight::Exponential, 0.1353352832366127},  // exp(-2)
                                                     {EndpointWeight::Gaussian, 0.1353352832366127},     // exp(-4/2)
                                                     {EndpointWeight::Cauchy, 0.2},                      // 1/(1 + 4)
                                                     {EndpointWeight::Huber, 0.5},                       // 1/2
                                                     {EndpointWeight::None, 1.0}};
  for (const auto& [form, weight] : forms) {
    epcc::PlanePrototype prototype = unitSquare();
    prototype.distances = 2;
    prototype.mean_distance = 0.1;
    prototype.add({0.5, 0.5, 2.4}, form);
    EXPECT_NEAR(prototype.mean_distance, 0.2, 1e-12);
    EXPECT_NEAR(prototype.statistics.covariance(2, 2), weight * 0.16 / 5.0, 1e-12) << static_cast<int>(form);
  }
}

TEST(PlanePrototype, WeightsBelowTheMeanDistance) {
  // Distances 0.3 and then 0.1: mean 0.2, ratio 1/2. (At 2 the exponential and the Gaussian form agree.)
  const std::pair<EndpointWeight, double> forms[] = {{EndpointWeight::Printed, 0.7788007830714049},      // exp(-1/4)
                                                     {EndpointWeight::Exponential, 0.6065306597126334},  // exp(-1/2)
                                                     {EndpointWeight::Gaussian, 0.8824969025845955},     // exp(-1/8)
                                                     {EndpointWeight::Cauchy, 0.8},                      // 1/(1 + 1/4)
                                                     {EndpointWeight::Huber, 1.0},
                                                     {EndpointWeight::None, 1.0}};
  for (const auto& [form, weight] : forms) {
    epcc::PlanePrototype prototype = unitSquare();
    prototype.distances = 1;
    prototype.mean_distance = 0.3;
    prototype.add({0.5, 0.5, 2.1}, form);
    EXPECT_NEAR(prototype.statistics.covariance(2, 2), weight * 0.01 / 5.0, 1e-12) << static_cast<int>(form);
  }
}

TEST_F(PlaneClusteringTest, TheWeightOfTheParametersIsUsed) {
  // The third segment lies 4 mm off the plane of the first two, and counts by its weight alone.
  const auto thickness = [this](EndpointWeight form) {
    parameters_.endpoint_weight = form;
    auto clustering = make();
    for (int i = 0; i < 3; ++i) clustering.addLine({vertical(0.01 * i, i < 2 ? 2.0 : 2.004)});
    EXPECT_EQ(clustering.planes().size(), 1u);
    return clustering.planes()[0].statistics.covariance(2, 2);
  };
  EXPECT_LT(thickness(EndpointWeight::Printed), thickness(EndpointWeight::None));
  EXPECT_EQ(thickness(EndpointWeight::Printed), thickness(PaperParameters().endpoint_weight));
}

TEST(PlanePrototype, AnEndpointOnThePlaneDividesNothingByZero) {
  epcc::PlanePrototype prototype;
  for (const auto& p : {Eigen::Vector3d(0, 0, 2), Eigen::Vector3d(1, 0, 2), Eigen::Vector3d(0, 1, 2)})
    prototype.statistics.add(p);
  prototype.refit();
  prototype.add({1, 1, 2}, EndpointWeight::Printed);
  prototype.refit();
  EXPECT_TRUE(prototype.statistics.covariance.allFinite());
  EXPECT_TRUE(prototype.normal.allFinite());
}

}  // namespace
