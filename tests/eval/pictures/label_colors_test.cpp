// SPDX-License-Identifier: BSD-3-Clause
// The palette is fixed and its neighbours can be told apart.
#include "eval/pictures/label_colors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using epcc::labelColor;
using epcc::Rgb;

double distance(const Rgb& a, const Rgb& b) {
  const double r = a.r - b.r;
  const double g = a.g - b.g;
  const double blue = a.b - b.b;
  return std::sqrt(r * r + g * g + blue * blue);
}

TEST(LabelColors, NoPlaneIsBlackAndIgnoreIsGrey) {
  EXPECT_EQ(distance(labelColor(0), Rgb{0, 0, 0}), 0.0);
  EXPECT_EQ(distance(labelColor(-3), Rgb{0, 0, 0}), 0.0);
  const Rgb ignored = labelColor(epcc::kIgnoreLabel);
  EXPECT_EQ(ignored.r, ignored.g);
  EXPECT_EQ(ignored.g, ignored.b);
}

TEST(LabelColors, LabelsOfAFrameDiffer) {
  for (int a = 1; a <= 40; ++a) {
    for (int b = a + 1; b <= a + 12; ++b) EXPECT_GT(distance(labelColor(a), labelColor(b)), 40.0) << a << " " << b;
  }
}

TEST(LabelColors, ColoursStandOutFromGreyRelief) {
  for (int label = 1; label <= 200; ++label) {
    const Rgb c = labelColor(label);
    const int spread = std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b});
    EXPECT_GT(spread, 100) << label;
  }
}

}  // namespace
