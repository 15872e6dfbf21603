// SPDX-License-Identifier: BSD-3-Clause
// Samples take the plane that they expect where their depth agrees, alike on every vector unit.
#include "inverse_depth/known_row.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/support/vector_units.h"

namespace epcc {
namespace {

TEST(KnownRow, ASampleWithoutALabelTakesThePlaneThatItLiesOn) {
  const std::vector<KnownRowPlane> planes = {{}, {0.5f, 0.2f, 1.0f, 9.0f}, {-0.3f, 0.1f, 0.8f, 16.0f}};
  constexpr float kAlong = 0.25f;
  std::mt19937 random(7);
  std::normal_distribution<float> noise;
  for (const int width : {1, 15, 16, 17, 160, 167}) {
    std::vector<float> w, across;
    const std::vector<float> weight(static_cast<std::size_t>(width), 400.0f);
    std::vector<std::int32_t> expected, before;
    for (int k = 0; k < width; ++k) {
      across.push_back(0.01f * static_cast<float>(k) - 0.4f);
      const std::int32_t plane = k / 40 % 4 - 1;  // -1 unseen, 0 none: in blocks, and mixed where these end
      expected.push_back(k % 31 == 0 ? 1 : plane);
      before.push_back(k % 13 == 0 ? 2 : k % 17 == 0 ? -1 : 0);
      const KnownRowPlane& on = planes[expected.back() > 0 ? static_cast<std::size_t>(expected.back()) : 1];
      w.push_back(on.x * across.back() + on.y * kAlong + on.z + 0.15f * noise(random));
    }
    std::vector<std::int32_t> right = before;
    std::size_t taken = 0;
    for (std::size_t k = 0; k < w.size(); ++k) {
      if (before[k] != 0 || expected[k] <= 0) continue;
      const KnownRowPlane& on = planes[static_cast<std::size_t>(expected[k])];
      const float residual = w[k] - (on.x * across[k] + (on.y * kAlong + on.z));
      if (residual * residual * weight[k] > on.max_square) continue;
      right[k] = expected[k];
      ++taken;
    }
    if (width > 100) {
      EXPECT_GT(taken, 40u);
      EXPECT_LT(taken, 90u);
    }
    test::onEveryVectorUnit([&] {
      std::vector<std::int32_t> labels = before;
      const KnownRow row = {w.data(), weight.data(), across.data(), kAlong, width};
      EXPECT_EQ(takeExpected(row, planes.data(), expected.data(), labels.data()), taken);
      EXPECT_EQ(labels, right) << width;
    });
  }
}

}  // namespace
}  // namespace epcc
