// SPDX-License-Identifier: BSD-3-Clause
// The defaults are valid; each field out of range is named.
#include "epcc_segmentation/parameters.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace {

using epcc::Parameters;

TEST(Parameters, DefaultsAreValidAndThePapers) {
  const Parameters p;
  EXPECT_EQ(p.validate(), "");
  EXPECT_EQ(p.line.minimumSamples(), 8);
  EXPECT_EQ(p.line.buffer_samples, 2 * p.line.minimumSamples());
  EXPECT_EQ(p.plane.max_gap, 0.15);
}

TEST(Parameters, EveryFieldOutOfRangeIsNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<const char*, std::function<void(Parameters&)>> cases[] = {
      {"fit_samples", [](Parameters& p) { p.line.fit_samples = 1; }},
      {"validation_samples", [](Parameters& p) { p.line.validation_samples = 0; }},
      {"buffer_samples", [](Parameters& p) { p.line.buffer_samples = 7; }},
      {"line.k_max", [](Parameters& p) { p.line.k_max = 0.0; }},
      {"line.k_max", [nan](Parameters& p) { p.line.k_max = nan; }},
      {"projection_floor", [](Parameters& p) { p.line.projection_floor = 1.5; }},
      {"plane.k_max", [](Parameters& p) { p.plane.k_max = -1.0; }},
      {"max_gap", [nan](Parameters& p) { p.plane.max_gap = nan; }},
      {"look_back", [](Parameters& p) { p.plane.look_back = 0; }},
      {"pair_look_back", [](Parameters& p) { p.plane.pair_look_back = 5; }},
      {"max_start_angle", [](Parameters& p) { p.plane.max_start_angle = 91.0; }},
      {"min_segments", [](Parameters& p) { p.plane.min_segments = 0; }},
      {"min_points", [](Parameters& p) { p.plane.min_points = -1; }},
      {"threads", [](Parameters& p) { p.threads = 0; }},
  };
  for (const auto& [field, spoil] : cases) {
    Parameters p;
    spoil(p);
    EXPECT_NE(p.validate().find(field), std::string::npos) << field << ": " << p.validate();
  }
}

}  // namespace
