// SPDX-License-Identifier: BSD-3-Clause
// Range checks of the parameters, in words.
#include "epcc_segmentation/parameters.h"

#include <sstream>

namespace epcc {

namespace {

/// "NAME must be in [LOW, HIGH] UNIT, not VALUE" unless it is; NaN never is.
template <typename Number>
std::string checkRange(const char* name, Number value, Number low, Number high, const char* unit = "") {
  if (value >= low && value <= high) return {};
  std::ostringstream text;
  text << name << " must be in [" << low << ", " << high << "]" << unit << ", not " << value;
  return text.str();
}

std::string firstOf(std::initializer_list<std::string> problems) {
  for (const auto& problem : problems)
    if (!problem.empty()) return problem;
  return {};
}

constexpr double kSmallest = 1e-6;

}  // namespace

std::string LineClusteringParameters::validate() const {
  return firstOf({checkRange("line.fit_samples (l)", fit_samples, 2, 100),
                  checkRange("line.validation_samples (l_v)", validation_samples, 1, 100),
                  checkRange("line.buffer_samples (n_buf)", buffer_samples, fit_samples + validation_samples, 1000),
                  checkRange("line.k_max", k_max, kSmallest, 100.0),
                  checkRange("line.projection_floor", projection_floor, 0.0, 1.0)});
}

std::string PlaneClusteringParameters::validate() const {
  return firstOf({checkRange("plane.k_max", k_max, kSmallest, 100.0),
                  checkRange("plane.max_gap (d_1)", max_gap, 0.0, 100.0, " m"),
                  checkRange("plane.look_back", look_back, 1, 100),
                  checkRange("plane.pair_look_back", pair_look_back, 1, look_back),
                  checkRange("plane.max_start_angle", max_start_angle, kSmallest, 90.0, " degrees"),
                  checkRange("plane.min_segments", min_segments, 1, 1000000),
                  checkRange("plane.min_points", min_points, 0, 1000000000)});
}

std::string Parameters::validate() const {
  return firstOf({line.validate(), plane.validate(), checkRange("threads", threads, 1, 256)});
}

}  // namespace epcc
