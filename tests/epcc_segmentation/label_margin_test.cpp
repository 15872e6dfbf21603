// SPDX-License-Identifier: BSD-3-Clause
// What is left of labels beside others, against a plain loop, on every vector unit.
#include "label_margin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tests/support/vector_units.h"

namespace epcc {
namespace {

std::vector<std::int32_t> inside(const std::vector<std::int32_t>& rows, std::size_t pitch, std::size_t count,
                                 std::size_t margin) {
  std::vector<std::int32_t> result(count + kBehindLabels);
  const std::int32_t* middle = rows.data() + pitch + margin;
  keepInside(middle, middle - pitch, middle + pitch, count, margin, result.data());
  result.resize(count);
  return result;
}

TEST(LabelMargin, IsWhereAnotherLabelIsNearOrNone) {
  constexpr std::size_t kPitch = 5 + 2 + kBehindLabels;
  std::vector<std::int32_t> rows(3 * kPitch, 0);
  const std::vector<std::int32_t> above = {1, 1, 0, 2, 2}, middle = {1, 1, 1, 2, 2}, below = {1, 3, 1, 0, 2};
  std::copy(above.begin(), above.end(), rows.begin() + 1);
  std::copy(middle.begin(), middle.end(), rows.begin() + kPitch + 1);
  std::copy(below.begin(), below.end(), rows.begin() + 2 * kPitch + 1);
  EXPECT_EQ(inside(rows, kPitch, 5, 1), (std::vector<std::int32_t>{0, 0, 0, 0, 0}));
  rows[kPitch] = 1;  // before the first
  EXPECT_EQ(inside(rows, kPitch, 5, 1), (std::vector<std::int32_t>{1, 0, 0, 0, 0}));
}

TEST(LabelMargin, IsThatOfAPlainLoopOnEveryVectorUnit) {
  std::mt19937 engine(3);
  for (const std::size_t count : {1u, 7u, 16u, 100u})
    for (const std::size_t margin : {1u, 2u}) {
      const std::size_t pitch = count + 2 * margin + kBehindLabels;
      std::vector<std::int32_t> rows(3 * pitch);
      for (auto& label : rows) label = std::max(0, static_cast<int>(engine() % 8) - 5);
      std::vector<std::int32_t> expected;
      for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t* here = rows.data() + pitch + margin + i;
        bool is_near = false;
        for (const std::int32_t label : {*(here - margin), *(here + margin), *(here - pitch), *(here + pitch)})
          is_near = is_near || label != *here;
        expected.push_back(is_near ? 0 : *here);
      }
      test::onEveryVectorUnit([&] { EXPECT_EQ(inside(rows, pitch, count, margin), expected) << count; });
    }
}

}  // namespace
}  // namespace epcc
