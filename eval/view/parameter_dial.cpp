// SPDX-License-Identifier: BSD-3-Clause
// Steps of 1, 2 or 5 in the second digit, so that many presses of a key leave a number one can write down.
#include "eval/view/parameter_dial.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace epcc {
namespace {

constexpr double kSmallest = 0.01;  // the number after 0

/// 0.1 for numbers from 1 to 2, 0.2 to 5, 0.5 to 10, and so on for every power of ten.
double stepAt(double magnitude) {
  const double power = std::pow(10.0, std::floor(std::log10(magnitude) + 1e-9));
  const double first_digit = magnitude / power + 1e-9;
  return 0.1 * power * (first_digit >= 5.0 ? 5.0 : first_digit >= 2.0 ? 2.0 : 1.0);
}

double nextNumber(double value, bool whole) {
  const double smallest = whole ? 1.0 : kSmallest;
  if (value < smallest) return smallest;
  const double step = std::max(whole ? 1.0 : 0.0, stepAt(value));
  return step * std::floor(value / step + 1.0 + 1e-6);
}

double previousNumber(double value, bool whole) {
  const double smallest = whole ? 1.0 : kSmallest;
  if (value <= smallest) return 0.0;
  const double step = std::max(whole ? 1.0 : 0.0, stepAt(value * (1.0 - 1e-6)));
  return std::max(smallest, step * std::ceil(value / step - 1.0 - 1e-6));
}

}  // namespace

std::vector<const ParameterField*> dialFields(Mode mode) {
  const char* const prefix = mode == Mode::Paper ? "paper." : "inverse_depth.";
  std::vector<const ParameterField*> fields;
  for (const ParameterField& field : parameterFields()) {
    const bool is_basic = std::strncmp(field.name, prefix, std::strlen(prefix)) == 0 &&
                          std::strchr(field.name + std::strlen(prefix), '.') == nullptr;
    if (is_basic || std::strcmp(field.name, "scan") == 0) fields.push_back(&field);
  }
  return fields;
}

double dialStep(const ParameterField& field, double value, int direction) {
  if (!field.choices.empty()) {
    const auto count = static_cast<int>(field.choices.size());
    return (static_cast<int>(value) + direction + count) % count;
  }
  const double next = direction > 0 ? nextNumber(value, field.whole) : previousNumber(value, field.whole);
  if (next < field.low && field.low == kAboveZero) return value;
  return std::clamp(next, field.low, field.high);
}

}  // namespace epcc
