// SPDX-License-Identifier: BSD-3-Clause
// The paper's studies by name.
#pragma once

#include <string>
#include <vector>

#include "eval/comparison/study.h"

namespace epcc {

/// criteria (Table 2, Fig. 20), buffer (Fig. 12), distance (Figs. 15, 24), scan (Figs. 22, 23), weights (Eq. 26).
std::vector<std::string> studyNames();

/// A study with the scenes, noise and seeds of the options. Throws std::invalid_argument for another name.
Study makeStudy(const std::string& name, const ComparisonOptions& options);

}  // namespace epcc
