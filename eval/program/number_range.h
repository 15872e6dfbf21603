// SPDX-License-Identifier: BSD-3-Clause
// Numbers on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

#include "datasets/support/number_text.h"

namespace epcc {

/// A number from `low` to `high`, which CLI::Range takes "nan" for. The help leaves the range to the text of the
/// option.
template <typename Number>
CLI::Validator within(Number low, Number high) {
  const CLI::Validator range = CLI::Range(low, high);
  const auto problem = [range](std::string& text) {
    const auto number = numberFrom(text);
    return number && std::isnan(*number) ? text + " is not a number" : range(text);
  };
  return CLI::Validator(problem, "");
}

}  // namespace epcc
