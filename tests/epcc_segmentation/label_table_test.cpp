// SPDX-License-Identifier: BSD-3-Clause
// Labels are counted and changed alike on every vector unit, as one by one.
#include "label_table.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "tests/support/vector_units.h"

namespace {

constexpr std::int32_t kCount = 5;

/// Runs of random length, some of them of labels that are none.
std::vector<std::int32_t> randomLabels(std::size_t size, int longest_run) {
  const std::int32_t any[] = {
      0, 1, 2, 3, 4, 5, 6, -1, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()};
  std::mt19937 random(static_cast<unsigned>(size) + 1);
  std::vector<std::int32_t> labels;
  while (labels.size() < size) {
    const std::int32_t label = any[random() % 10];
    for (auto k = random() % static_cast<unsigned>(longest_run) + 1; k > 0 && labels.size() < size; --k)
      labels.push_back(label);
  }
  return labels;
}

bool isOne(std::int32_t label) {
  return label >= 1 && label <= kCount;
}

TEST(LabelTable, CountsAndChangesAsOneByOne) {
  const std::vector<std::int32_t> new_label = {0, 1, 4, 0, 2, 5};  // 1 and 5 keep theirs, 3 disappears
  epcc::test::onEveryVectorUnit([&] {
    for (std::size_t size = 0; size < 150; ++size)
      for (const int longest_run : {1, 3, 40, 200}) {
        const std::vector<std::int32_t> labels = randomLabels(size, longest_run);
        std::vector<long> expected(kCount, 7), pixels(expected);
        std::vector<std::int32_t> expected_labels, changed(labels);
        bool stray = false;
        for (const std::int32_t label : labels) {
          if (isOne(label)) ++expected[static_cast<std::size_t>(label - 1)];
          stray = stray || (label != 0 && !isOne(label));
          expected_labels.push_back(isOne(label) ? new_label[static_cast<std::size_t>(label)] : 0);
        }
        EXPECT_EQ(epcc::countLabels(labels.data(), size, kCount, pixels.data()), stray);
        EXPECT_EQ(pixels, expected);
        epcc::changeLabels(changed.data(), size, kCount, new_label.data());
        EXPECT_EQ(changed, expected_labels);
      }
  });
}

}  // namespace
