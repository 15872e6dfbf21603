// SPDX-License-Identifier: BSD-3-Clause
// Steps of parameters: round numbers, within the range, there and back.
#include "eval/view/parameter_dial.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace epcc {
namespace {

const ParameterField& field(const std::string& name) {
  const auto& all = parameterFields();
  return *std::find_if(all.begin(), all.end(), [&](const ParameterField& each) { return name == each.name; });
}

std::vector<double> steps(const std::string& name, double value, int direction, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(value = dialStep(field(name), value, direction));
  return values;
}

void expectSteps(const std::vector<double>& found, const std::vector<double>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-9) << i;
}

TEST(ParameterDial, StepsAreRoundNumbers) {
  expectSteps(steps("inverse_depth.line_k_max", 1.5, 1, 7), {1.6, 1.7, 1.8, 1.9, 2.0, 2.2, 2.4});
  expectSteps(steps("inverse_depth.line_k_max", 9.5, 1, 3), {10.0, 11.0, 12.0});
  expectSteps(steps("inverse_depth.line_k_max", 1.1, -1, 3), {1.0, 0.95, 0.9});
}

TEST(ParameterDial, TheNextAfterAnOddNumberIsRound) {
  expectSteps(steps("inverse_depth.line_k_max", 1.5432, 1, 2), {1.6, 1.7});
  expectSteps(steps("inverse_depth.line_k_max", 1.5432, -1, 2), {1.5, 1.4});
}

TEST(ParameterDial, UpAndDownComesBack) {
  for (double value : {0.02, 0.5, 1.0, 1.9, 2.0, 4.8, 5.0, 10.0, 95.0}) {
    const ParameterField& k = field("paper.line_k_max");
    EXPECT_NEAR(dialStep(k, dialStep(k, value, 1), -1), value, 1e-9);
    EXPECT_NEAR(dialStep(k, dialStep(k, value, -1), 1), value, 1e-9);
  }
}

TEST(ParameterDial, StaysInTheRange) {
  EXPECT_EQ(dialStep(field("inverse_depth.line_k_max"), 100.0, 1), 100.0);
  EXPECT_EQ(dialStep(field("inverse_depth.line_k_max"), 0.01, -1), 0.01);  // 0 is none
  EXPECT_EQ(dialStep(field("inverse_depth.min_points"), 1.0, -1), 1.0);
  expectSteps(steps("inverse_depth.min_confidence", 0.95, 1, 2), {1.0, 1.0});
}

TEST(ParameterDial, ZeroIsReachedAndLeft) {
  expectSteps(steps("paper.max_gap", 0.01, -1, 1), {0.0});
  expectSteps(steps("paper.max_gap", 0.0, 1, 2), {0.01, 0.011});
  expectSteps(steps("inverse_depth.stride", 0.0, 1, 3), {1.0, 2.0, 3.0});
  expectSteps(steps("inverse_depth.stride", 2.0, -1, 3), {1.0, 0.0, 0.0});
}

TEST(ParameterDial, WholeNumbersStayWhole) {
  expectSteps(steps("inverse_depth.min_points", 60.0, 1, 2), {65.0, 70.0});
  expectSteps(steps("inverse_depth.min_points", 12.0, -1, 4), {11.0, 10.0, 9.0, 8.0});
}

TEST(ParameterDial, ChoicesGoRound) {
  expectSteps(steps("paper.criterion", 2.0, 1, 3), {3.0, 0.0, 1.0});
  expectSteps(steps("paper.criterion", 0.0, -1, 1), {3.0});
}

TEST(ParameterDial, EveryBasicFieldKeepsItsRangeOverManySteps) {
  for (const Mode mode : {Mode::InverseDepth, Mode::Paper}) {
    EXPECT_GE(dialFields(mode).size(), 7U);
    for (const ParameterField* each : dialFields(mode))
      for (const int direction : {1, -1}) {
        double value = each->get(Parameters());
        for (int i = 0; i < 300; ++i) value = dialStep(*each, value, direction);
        if (!each->choices.empty()) continue;
        EXPECT_GE(value, each->low) << each->name;
        EXPECT_LE(value, each->high) << each->name;
        const bool is_at_end = each->get(Parameters()) == (direction > 0 ? each->high : each->low);
        EXPECT_EQ(value == each->get(Parameters()), is_at_end) << each->name << ' ' << direction;
      }
  }
}

TEST(ParameterDial, FieldsAreThoseOfTheMode) {
  for (const ParameterField* each : dialFields(Mode::Paper))
    EXPECT_EQ(std::string(each->name).find("inverse_depth"), std::string::npos) << each->name;
}

}  // namespace
}  // namespace epcc
