// SPDX-License-Identifier: BSD-3-Clause
// The JSON list of planes: structure, values, contours with holes.
#include "datasets/files/plane_list.h"

#include <gtest/gtest.h>

#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

using nlohmann::json;

/// Plane 1 is a 5x5 ring around one pixel of plane 2, which has a second piece at the right.
PlaneSegmentation ring() {
  PlaneSegmentation result;
  result.width = 8;
  result.height = 5;
  result.labels.assign(40, 0);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 5; ++column) result.labels[static_cast<std::size_t>(8 * row + column)] = 1;
  result.labels[8 * 2 + 2] = 2;
  result.labels[8 * 4 + 7] = 2;
  result.planes.resize(2);
  Plane& plane = result.planes[0];
  plane.coefficients << 0.0, 0.6, -0.8, 1.25;
  plane.coefficients_covariance.diagonal() << 1.0, 2.0, 3.0, 4.0;
  plane.coefficients_covariance(0, 3) = plane.coefficients_covariance(3, 0) = 0.5;
  plane.centroid << 0.1, 0.2, 1.7;
  plane.rms = 0.003;
  plane.pixel_count = 24;
  result.planes[1].pixel_count = 2;
  return result;
}

TEST(PlaneListTest, HasVersionSizeAndFrame) {
  const json list = planeListJson(ring());
  EXPECT_EQ(list["version"], 1);
  EXPECT_EQ(list["width"], 8);
  EXPECT_EQ(list["height"], 5);
  EXPECT_EQ(list["frame"], "camera x right, y down, z forward");
  EXPECT_EQ(planeListJson(ring(), Projection::Spherical)["frame"], "spherical scan x forward, y left, z up");
}

TEST(PlaneListTest, PlaneHasAllItsValues) {
  const json list = planeListJson(ring());
  ASSERT_EQ(list["planes"].size(), 2u);
  const json& plane = list["planes"][0];
  EXPECT_EQ(plane["id"], 1);
  EXPECT_EQ(list["planes"][1]["id"], 2);
  EXPECT_EQ(plane["coefficients"], json({0.0, 0.6, -0.8, 1.25}));
  EXPECT_EQ(plane["coefficients_covariance"],
            json({{1.0, 0.0, 0.0, 0.5}, {0.0, 2.0, 0.0, 0.0}, {0.0, 0.0, 3.0, 0.0}, {0.5, 0.0, 0.0, 4.0}}));
  EXPECT_EQ(plane["centroid"], json({0.1, 0.2, 1.7}));
  EXPECT_EQ(plane["rms"], 0.003);
  EXPECT_EQ(plane["pixel_count"], 24);
}

TEST(PlaneListTest, ContoursHaveOuterBordersAndHoles) {
  const json list = planeListJson(ring());
  const json& ring_contour = list["planes"][0]["contour"];
  ASSERT_EQ(ring_contour["outer"].size(), 1u);
  ASSERT_EQ(ring_contour["holes"].size(), 1u);
  EXPECT_EQ(ring_contour["outer"][0].size(), 16u);
  for (const json& point : ring_contour["outer"][0]) {
    ASSERT_EQ(point.size(), 2u);
    const int column = point[0], row = point[1];
    EXPECT_TRUE(column == 0 || column == 4 || row == 0 || row == 4) << point;
  }
  for (const json& point : ring_contour["holes"][0]) {
    const int column = point[0], row = point[1];
    EXPECT_EQ(std::max(std::abs(column - 2), std::abs(row - 2)), 1) << point;
  }
  const json& pieces = list["planes"][1]["contour"];
  EXPECT_EQ(pieces["outer"], json({{{2, 2}}, {{7, 4}}}));
  EXPECT_TRUE(pieces["holes"].empty());
}

TEST(PlaneListTest, NoPlanesGiveAnEmptyList) {
  PlaneSegmentation nothing;
  nothing.width = 2;
  nothing.height = 2;
  nothing.labels.assign(4, 0);
  const json list = planeListJson(nothing);
  EXPECT_TRUE(list["planes"].is_array());
  EXPECT_TRUE(list["planes"].empty());
}

using PlaneListFileTest = test::TempFolderTest;

TEST_F(PlaneListFileTest, FileHoldsTheSame) {
  writePlaneList(path("planes.json"), ring());
  const std::string text = test::bytesOf(path("planes.json"));
  EXPECT_EQ(text.back(), '\n');
  EXPECT_EQ(json::parse(text), planeListJson(ring()));
  EXPECT_EQ(names(), std::vector<std::string>{"planes.json"});
}

}  // namespace
}  // namespace epcc
