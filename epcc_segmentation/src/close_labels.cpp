// SPDX-License-Identifier: BSD-3-Clause
// Labels lie in runs: each run is looked up once.
#include "close_labels.h"

#include <algorithm>

namespace epcc {

int closeLabels(int label_count, std::vector<std::int32_t>& labels) {
  std::vector<std::int32_t> present;
  std::int32_t before = 0;
  for (const std::int32_t label : labels) {
    if (label != before && label > 0 && label <= label_count) present.push_back(label);
    before = label;
  }
  std::sort(present.begin(), present.end());
  present.erase(std::unique(present.begin(), present.end()), present.end());
  before = 0;
  std::int32_t now = 0;
  for (std::int32_t& label : labels) {
    if (label != before) {
      before = label;
      const auto found = std::lower_bound(present.begin(), present.end(), label);
      const bool is_present = found != present.end() && *found == label;
      now = is_present ? static_cast<std::int32_t>(found - present.begin()) + 1 : 0;
    }
    label = now;
  }
  return static_cast<int>(present.size());
}

}  // namespace epcc
