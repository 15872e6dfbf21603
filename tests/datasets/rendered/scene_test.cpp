// SPDX-License-Identifier: BSD-3-Clause
// The four scenes: number of surfaces, exact labels and coefficients, clutter, seeds, other cameras.
#include "datasets/rendered/scene.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace epcc {
namespace {

const std::map<std::string, int> kExpected = {{"a", 5}, {"b", 11}, {"c", 9}, {"d", 9}};

std::map<int, int> labelCounts(const LabelledFrame& frame) {
  std::map<int, int> counts;
  for (const auto label : frame.labels.data) ++counts[label];
  return counts;
}

// Largest |n.p + d| / z over the labelled pixels, with the coefficients of the frame's JSON.
double worstDistance(const LabelledFrame& frame) {
  std::map<int, Eigen::Vector4d> planes;
  for (const auto& plane : frame.camera.extra["planes"]) {
    const auto c = plane["coefficients"].get<std::vector<double>>();
    planes[plane["id"].get<int>()] = {c[0], c[1], c[2], c[3]};
  }
  const PinholeCamera& camera = frame.camera.camera;
  double worst = 0.0;
  for (int row = 0; row < frame.depth.height; ++row) {
    for (int column = 0; column < frame.depth.width; ++column) {
      const int label = frame.labels.at(row, column);
      if (label == 0 || label == kIgnoreLabel) continue;
      const double z = static_cast<double>(frame.depth.at(row, column));
      const Eigen::Vector4d p(z * (column - camera.cx) / camera.fx, z * (row - camera.cy) / camera.fy, z, 1.0);
      worst = std::max(worst, std::fabs(planes.at(label).dot(p)) / z);
    }
  }
  return worst;
}

class EveryScene : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryScene, ShowsTheSameNumberOfSurfacesForFiftySeeds) {
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::repeats(50)); ++seed) {
    const LabelledFrame frame = renderScene(GetParam(), seed);
    auto counts = labelCounts(frame);
    counts.erase(0);
    ASSERT_EQ(counts.count(kIgnoreLabel), 0U) << seed;
    ASSERT_EQ(static_cast<int>(counts.size()), kExpected.at(GetParam())) << seed;
    ASSERT_EQ(counts.rbegin()->first, kExpected.at(GetParam())) << "labels have gaps, seed " << seed;
    for (const auto& [label, pixels] : counts) ASSERT_GE(pixels, 900) << "label " << label << ", seed " << seed;
    for (const auto& plane : frame.camera.extra["planes"])
      ASSERT_EQ(plane["pixels"].get<int>(), counts[plane["id"].get<int>()]) << seed;
  }
}

TEST_P(EveryScene, PutsEveryLabelledPointOnItsPlane) {
  for (const std::uint64_t seed : {0U, 7U, 31U}) EXPECT_LT(worstDistance(renderScene(GetParam(), seed)), 1e-5) << seed;
}

TEST_P(EveryScene, HasUnitNormalsTowardsTheCamera) {
  const LabelledFrame frame = renderScene(GetParam(), 3);
  ASSERT_EQ(static_cast<int>(frame.camera.extra["planes"].size()), kExpected.at(GetParam()));
  for (const auto& plane : frame.camera.extra["planes"]) {
    const auto c = plane["coefficients"].get<std::vector<double>>();
    EXPECT_NEAR(std::hypot(c[0], c[1], c[2]), 1.0, 1e-12);
    EXPECT_GT(c[3], 0.0);
  }
}

TEST_P(EveryScene, HasDepthEverywhere) {
  const LabelledFrame frame = renderScene(GetParam(), 11);
  ASSERT_EQ(frame.depth.data.size(), 480U * 270U);
  const auto [least, most] = std::minmax_element(frame.depth.data.begin(), frame.depth.data.end());
  EXPECT_GT(*least, 0.2F);
  EXPECT_LT(*most, 10.0F);
}

TEST_P(EveryScene, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const LabelledFrame first = renderScene(GetParam(), 5), again = renderScene(GetParam(), 5),
                      other = renderScene(GetParam(), 6);
  EXPECT_EQ(first.depth.data, again.depth.data);
  EXPECT_EQ(first.labels.data, again.labels.data);
  EXPECT_EQ(first.camera.extra, again.camera.extra);
  EXPECT_NE(first.depth.data, other.depth.data);
}

TEST_P(EveryScene, LooksTheSameOnAFinerGrid) {
  SceneOptions fine;
  fine.camera = sceneCamera(960, 540);
  const LabelledFrame coarse = renderScene(GetParam(), 2), frame = renderScene(GetParam(), 2, fine);
  ASSERT_EQ(frame.depth.width, 960);
  EXPECT_LT(worstDistance(frame), 1e-5);
  for (const auto& [label, pixels] : labelCounts(coarse)) {
    const auto counts = labelCounts(frame);
    ASSERT_EQ(counts.count(label), 1U) << label;
    EXPECT_NEAR(counts.at(label) / 4.0, pixels, 0.05 * pixels + 60.0) << label;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, ::testing::ValuesIn(sceneNames()));

TEST(Scenes, AreTheFourOfTheComparison) {
  ASSERT_EQ(sceneNames(), (std::vector<std::string>{"a", "b", "c", "d"}));
  for (const auto& [name, surfaces] : kExpected) EXPECT_EQ(sceneSurfaces(name), surfaces);
  EXPECT_EQ(sceneSurfaces("e"), 0);
}

TEST(Scenes, HaveClutterButForTheDesk) {
  EXPECT_EQ(labelCounts(renderScene("a", 1)).count(0), 0U);
  for (const char* name : {"b", "c", "d"}) EXPECT_GT(labelCounts(renderScene(name, 1))[0], 500) << name;
}

TEST(Scenes, CorridorIsSevenToTenMetresDeep) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const LabelledFrame frame = renderScene("d", seed);
    const float deepest = *std::max_element(frame.depth.data.begin(), frame.depth.data.end());
    EXPECT_GT(deepest, 7.0F);
    EXPECT_LT(deepest, 10.0F);
  }
}

TEST(Scenes, IgnoreWhatIsSeenTooSmall) {
  SceneOptions options;
  options.min_surface_pixels = 3000;
  auto counts = labelCounts(renderScene("d", 0, options));
  EXPECT_GT(counts[kIgnoreLabel], 0);
  counts.erase(0);
  counts.erase(kIgnoreLabel);
  EXPECT_LT(counts.size(), 9U);
  for (const auto& [label, pixels] : counts) EXPECT_GE(pixels, 3000) << label;
}

TEST(Scenes, RefuseUnknownNamesAndCameras) {
  EXPECT_THROW(renderScene("kitchen", 0), std::invalid_argument);
  EXPECT_THROW(renderScene("", 0), std::invalid_argument);
  SceneOptions options;
  options.camera.fx = 0.0;
  EXPECT_THROW(renderScene("a", 0, options), std::invalid_argument);
}

}  // namespace
}  // namespace epcc
