// SPDX-License-Identifier: BSD-3-Clause
// Every vector unit gives the same bits.
#include "epcc_segmentation/vector_unit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "depth_rows.h"
#include "epcc_segmentation/plane_extractor.h"
#include "inverse_depth/depth_inversion.h"
#include "inverse_depth/inverse_depth_image.h"
#include "tests/support/rendered_room.h"
#include "tests/support/vector_units.h"

namespace {

using epcc::test::onEveryVectorUnit;

TEST(VectorUnit, TheFastestIsInUseAndAnyCanBeChosen) {
  const std::vector<std::string> units = epcc::vectorUnits();
  ASSERT_FALSE(units.empty());
  const std::string in_use = epcc::vectorUnit();
  EXPECT_NE(std::find(units.begin(), units.end(), in_use), units.end());
  for (const std::string& unit : units) {
    EXPECT_TRUE(epcc::setVectorUnit(unit));
    EXPECT_EQ(epcc::vectorUnit(), unit);
  }
  EXPECT_TRUE(epcc::setVectorUnit(in_use));
  EXPECT_EQ(epcc::vectorUnit(), in_use);
  EXPECT_FALSE(epcc::setVectorUnit("abacus"));
  EXPECT_EQ(epcc::vectorUnit(), in_use);
}

TEST(VectorUnit, DepthsAreReadAlikeAndNoneBeyondTheEndIsTouched) {
  std::vector<float> depth = {0.0f,
                              -1.0f,
                              1.0f,
                              0.3f,
                              1e-42f,
                              3e38f,
                              1e5f,
                              100001.0f,
                              1.01e-6f,
                              0.99e-6f,
                              std::numeric_limits<float>::infinity(),
                              std::numeric_limits<float>::quiet_NaN()};
  for (int i = 0; i < 40; ++i) depth.push_back(0.1f * static_cast<float>(i));
  std::vector<std::uint16_t> units(depth.size());
  for (std::size_t i = 0; i < units.size(); ++i) units[i] = static_cast<std::uint16_t>(i * 1401);
  epcc::InverseDepthNoise noise;
  noise.a2 = 4e-6;
  noise.b2 = 9e-6;
  noise.place2 = 1e-7;
  std::vector<float> first_weight;
  onEveryVectorUnit([&] {
    for (std::size_t count = 0; count < depth.size(); ++count) {
      std::vector<float> w(depth.size() + 1, 7.0f), weight(w), metres(w), feet(w);
      epcc::depthsInMetres(depth.data(), count, 0.3048, feet.data());
      epcc::invertDepths(depth.data(), count, w.data());
      epcc::weighInverseDepths(w.data(), count, noise, 0.9f, weight.data());
      epcc::depthsInMetres(units.data(), count, 0.001, metres.data());
      for (std::size_t i = 0; i < count; ++i) {
        const bool valid =
            depth[i] > 0.0f && depth[i] <= epcc::kFarthestMeasured && 1.0f / depth[i] <= epcc::kLargestInverse;
        EXPECT_EQ(w[i], valid ? 1.0f / depth[i] : 0.0f) << i;
        EXPECT_EQ(metres[i], static_cast<float>(units[i] * 0.001)) << i;
        const double z = static_cast<double>(depth[i]) * 0.3048;
        const bool finite = z > 0.0 && z <= static_cast<double>(std::numeric_limits<float>::max());
        EXPECT_EQ(feet[i], static_cast<float>(finite ? z : 0.0)) << i;
        const double expected = 0.81 / noise.variance(static_cast<double>(w[i]) * 0.9f);
        EXPECT_NEAR(static_cast<double>(weight[i]), expected, 1e-5 * expected) << i;
      }
      if (count + 1 == depth.size()) {
        if (first_weight.empty()) first_weight = weight;
        EXPECT_EQ(weight, first_weight);
      }
      for (const auto* values : {&w, &weight, &metres, &feet})
        for (std::size_t i = count; i < values->size(); ++i) EXPECT_EQ((*values)[i], 7.0f) << count;
    }
  });
}

// S1 counts samples by their weights: one that is none would be looked for before the beginning of the scan line.
TEST(VectorUnit, WeightsArePositiveAndFiniteWhateverTheNoise) {
  const std::vector<float> w = {1e-42f, 1e-38f, 1e-20f, 0.5f, 1e19f, 1e20f, 3e38f, 0.0f};
  epcc::InverseDepthNoise absurd_rays, no_place, no_error;
  absurd_rays.place2 = 1e100;
  no_place.a2 = 1e-6;
  no_error.b2 = 1e-30;
  onEveryVectorUnit([&] {
    for (const epcc::InverseDepthNoise& noise : {absurd_rays, no_place, no_error})
      for (const float scale : {1.0f, 1e-30f, 0.0f}) {
        std::vector<float> weight(w.size());
        epcc::weighInverseDepths(w.data(), w.size(), noise, scale, weight.data());
        for (std::size_t i = 0; i < w.size(); ++i)
          EXPECT_TRUE(weight[i] > 0.0f && weight[i] <= std::numeric_limits<float>::max()) << w[i] << ' ' << weight[i];
      }
  });
}

TEST(VectorUnit, NoisyRoomsHaveTheSameLabelsAndPlanesOnEach) {
  const epcc::SensorModel sensor = epcc::SensorModel::axial(0.003, 0.002, 1.5);
  epcc::Parameters rows;
  rows.scan = epcc::ScanDirection::Rows;
  epcc::Parameters fine;
  fine.inverse_depth.stride = 1;
  for (const epcc::Parameters& parameters : {epcc::Parameters(), fine, rows, epcc::Parameters::forPaper()})
    for (const int width : {640, 333, 17}) {
      auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(width, width * 3 / 4));
      epcc::test::addNoise(room, sensor, 7);
      for (std::size_t i = 0; i < room.depth.size(); i += 11) room.depth[i] = 0.0f;
      for (const bool given : {true, false}) {
        epcc::PlaneSegmentation first;
        onEveryVectorUnit([&] {
          epcc::PlaneExtractor extractor(parameters, given ? std::optional(sensor) : std::nullopt);
          epcc::PlaneSegmentation result;
          ASSERT_TRUE(extractor.extract(room.frame(), result)) << extractor.error();
          if (first.labels.empty()) first = result;
          EXPECT_EQ(result.labels, first.labels) << width;
          ASSERT_EQ(result.planes.size(), first.planes.size()) << width;
          for (std::size_t k = 0; k < first.planes.size(); ++k)
            EXPECT_EQ(result.planes[k].coefficients, first.planes[k].coefficients) << width;
        });
        EXPECT_GE(first.planes.size(), width > 17 ? 3u : 0u);
      }
    }
}

}  // namespace
