// SPDX-License-Identifier: BSD-3-Clause
// Values of any distribution come out in order.
#include "sensor/ordered_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace epcc {
namespace {

void expectOrdered(std::vector<float> values, const char* what) {
  std::vector<float> expected = values;
  std::sort(expected.begin(), expected.end());
  orderValues(values.data(), static_cast<int>(values.size()));
  EXPECT_EQ(values, expected) << what << ", " << values.size() << " values";
}

TEST(OrderedValues, AreThoseOfAnyDistribution) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<float> uniform(0.1f, 2.0f);
  for (const std::size_t count : {0u, 1u, 2u, 3u, 16u, 17u, 63u, 64u, 200u, 256u}) {
    std::vector<float> values(count);
    for (float& value : values) value = uniform(generator);
    expectOrdered(values, "even");
    for (float& value : values) value = std::round(7.0f * value);
    expectOrdered(values, "quantised");
    for (float& value : values) value = 1.0f + 1e-6f * uniform(generator);
    if (count > 0) values[count / 2] = 1e20f;  // all others share a bucket
    expectOrdered(values, "far from one");
    for (float& value : values) value = 1.5f;
    expectOrdered(values, "equal");
    for (float& value : values) value = uniform(generator) * std::numeric_limits<float>::denorm_min() * 4.0f;
    expectOrdered(values, "denormal");
    for (float& value : values) value = (uniform(generator) - 1.0f) * 3.3e38f;
    expectOrdered(values, "as far as numbers go");
  }
}

}  // namespace
}  // namespace epcc
