// SPDX-License-Identifier: BSD-3-Clause
// The methods that epcc_eval is asked for, in the order of the reports.
#pragma once

#include <string>
#include <vector>

#include "eval/batch/eval_options.h"
#include "eval/experiment/experiment.h"

namespace epcc {

/// Names of one of the program's methods with so many seeds: a method that draws at random is one for each seed, NAME,
/// NAME-seed1, NAME-seed2 ...; the others are themselves.
std::vector<std::string> seededNames(const std::string& method, int seeds);

/// The program's methods with their seeds, then the predictions.
std::vector<Method> evalMethods(const EvalOptions& options);

}  // namespace epcc
