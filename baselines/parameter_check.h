// SPDX-License-Identifier: BSD-3-Clause
// Range checks of the baselines' parameters, in words.
#pragma once

#include <initializer_list>
#include <sstream>
#include <string>

namespace epcc {

/// "NAME must be in [LOW, HIGH], not VALUE" unless it is; NaN never is.
template <typename Number>
std::string checkParameter(const char* name, Number value, Number low, Number high) {
  if (value >= low && value <= high) return {};
  std::ostringstream text;
  text << name << " must be in [" << low << ", " << high << "], not " << value;
  return text.str();
}

/// The first text that is not empty, or an empty one.
inline std::string firstProblem(std::initializer_list<std::string> problems) {
  for (const auto& problem : problems)
    if (!problem.empty()) return problem;
  return {};
}

}  // namespace epcc
