// SPDX-License-Identifier: BSD-3-Clause
// Errors of planes whose difference is known, and camera files of every shape.
#include "eval/measures/plane_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/eval/measures/label_rows.h"

namespace {

using epcc::Plane;
using epcc::PlaneError;
using epcc::TruePlanes;
using epcc::test::tableOf;

Plane planeOf(const Eigen::Vector4d& coefficients) {
  Plane plane;
  plane.coefficients = coefficients;
  return plane;
}

Eigen::Vector4d tilted(double degrees, double d) {
  const double angle = degrees * M_PI / 180.0;
  return {std::sin(angle), 0.0, -std::cos(angle), d};
}

std::vector<PlaneError> errorsOf(const Eigen::Vector4d& truth, const Eigen::Vector4d& found) {
  return epcc::planeErrors(tableOf({{10, 1, 1}}), TruePlanes{{1, truth}}, {planeOf(found)});
}

TEST(PlaneErrors, AngleAndOffset) {
  const PlaneError error = errorsOf(tilted(0.0, 2.0), tilted(3.0, 2.05)).at(0);
  EXPECT_NEAR(error.normal_degrees, 3.0, 1e-9);
  EXPECT_NEAR(error.offset_metres, 0.05, 1e-12);
}

TEST(PlaneErrors, TheSignOfThePlaneDoesNotMatter) {
  const PlaneError error = errorsOf(tilted(10.0, 2.0), -tilted(11.0, 1.9)).at(0);
  EXPECT_NEAR(error.normal_degrees, 1.0, 1e-9);
  EXPECT_NEAR(error.offset_metres, 0.1, 1e-12);
}

TEST(PlaneErrors, TinyAnglesAreNotLostAndRightAnglesAreNinety) {
  EXPECT_NEAR(errorsOf(tilted(0.0, 1.0), tilted(1e-6, 1.0)).at(0).normal_degrees, 1e-6, 1e-12);
  EXPECT_NEAR(errorsOf(tilted(0.0, 1.0), tilted(90.0, 1.0)).at(0).normal_degrees, 90.0, 1e-9);
}

TEST(PlaneErrors, IdsThatAreNoLabelsArePassedOver) {
  const auto planes = epcc::truePlanes(nlohmann::json::parse(
      R"({"planes": [{"id": 4294967299, "coefficients": [0, 0, -1, 1]}, {"id": 18446744073709551615, "coefficients": [0, 0, -1, 1]},
                     {"id": 0, "coefficients": [0, 0, -1, 1]}, {"id": -3, "coefficients": [0, 0, -1, 1]},
                     {"id": 65535, "coefficients": [0, 0, -1, 1]}, {"id": 65534, "coefficients": [0, 0, -1, 1]}]})"));
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_EQ(planes.begin()->first, 65534);
}

TEST(PlaneErrors, OfTheLargestClusterThatTheSurfaceDominates) {
  const std::vector<Plane> planes = {planeOf(tilted(1.0, 1.0)), planeOf(tilted(2.0, 1.0)), planeOf(tilted(4.0, 1.0))};
  // Cluster 3 holds most of surface 7 but belongs to surface 8.
  const auto errors = epcc::planeErrors(tableOf({{20, 1, 7}, {30, 2, 7}, {40, 3, 7}, {50, 3, 8}, {9, 0, 9}}),
                                        TruePlanes{{7, tilted(0.0, 1.0)}, {9, tilted(0.0, 1.0)}}, planes);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].surface_id, 7);
  EXPECT_EQ(errors[0].cluster_id, 2);
  EXPECT_NEAR(errors[0].normal_degrees, 2.0, 1e-9);
}

TEST(PlaneErrors, PixelsWithoutALabelAreNoCluster) {
  const auto errors =
      epcc::planeErrors(tableOf({{90, 0, 1}, {20, 1, 1}, {10, 2, 1}}), TruePlanes{{1, tilted(0.0, 1.0)}},
                        {planeOf(tilted(1.0, 1.0)), planeOf(tilted(2.0, 1.0))});
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].cluster_id, 1);
}

TEST(PlaneErrors, ClusterWithoutAPlaneHasNoError) {
  EXPECT_TRUE(epcc::planeErrors(tableOf({{10, 5, 1}}), TruePlanes{{1, tilted(0.0, 1.0)}}, {}).empty());
  EXPECT_TRUE(errorsOf(tilted(0.0, 1.0), Eigen::Vector4d::Zero()).empty());
}

TEST(PlaneErrors, NoiseIsNoSurface) {
  EXPECT_TRUE(epcc::planeErrors(tableOf({{10, 1, 0}, {5, 1, 1}}), TruePlanes{{0, tilted(0.0, 1.0)}, {1, tilted(0, 1)}},
                                {planeOf(tilted(1.0, 1.0))})
                  .empty());
}

TEST(PlaneErrors, SumsAndMeans) {
  epcc::PlaneErrorSums sums = epcc::sumPlaneErrors({{1, 1, 2.0, 0.01}, {2, 2, 4.0, 0.03}});
  sums += epcc::sumPlaneErrors({{1, 1, 0.0, 0.05}});
  EXPECT_EQ(sums.planes, 3);
  EXPECT_DOUBLE_EQ(sums.meanNormalDegrees(), 2.0);
  EXPECT_DOUBLE_EQ(sums.meanOffsetMetres(), 0.03);
  EXPECT_TRUE(std::isnan(epcc::PlaneErrorSums().meanNormalDegrees()));
  EXPECT_TRUE(std::isnan(epcc::PlaneErrorSums().meanOffsetMetres()));
}

TEST(TruePlanes, ReadsTheListAndNormalizes) {
  const auto planes = epcc::truePlanes(nlohmann::json::parse(
      R"({"planes": [{"id": 3, "coefficients": [0, 0, -2, 4]}, {"id": 8, "coefficients": [0, -1, 0, 1.5], "x": 1}]})"));
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_EQ(planes.at(3), Eigen::Vector4d(0, 0, -1, 2));
  EXPECT_EQ(planes.at(8), Eigen::Vector4d(0, -1, 0, 1.5));
}

TEST(TruePlanes, PassesOverWhatIsNoPlane) {
  for (const char* text :
       {"{}", "null", R"({"planes": 15})", R"({"planes": null})", R"({"planes": {"id": 1}})",
        R"({"planes": [1, "a", null, []]})", R"({"planes": [{"id": 1}]})",
        R"({"planes": [{"coefficients": [0, 0, 1, 1]}]})", R"({"planes": [{"id": "1", "coefficients": [0, 0, 1, 1]}]})",
        R"({"planes": [{"id": 1, "coefficients": [0, 0, 1]}]})",
        R"({"planes": [{"id": 1, "coefficients": [0, 0, "1", 1]}]})",
        R"({"planes": [{"id": 1, "coefficients": [0, 0, 0, 1]}]})"})
    EXPECT_TRUE(epcc::truePlanes(nlohmann::json::parse(text)).empty()) << text;
}

}  // namespace
