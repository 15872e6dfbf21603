// SPDX-License-Identifier: BSD-3-Clause
// Label images written as runs of pixels.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "eval/measures/overlap_table.h"

namespace epcc::test {

/// So many pixels with this label and this truth.
struct Run {
  int pixels;
  std::int32_t label;
  std::int32_t truth;
  bool has_depth = true;
};

constexpr std::int32_t kIgnore = kIgnoreLabel;

inline OverlapTable tableOf(const std::vector<Run>& runs) {
  std::vector<std::int32_t> labels, truth;
  std::vector<std::uint8_t> depth;
  for (const Run& run : runs) {
    labels.insert(labels.end(), run.pixels, run.label);
    truth.insert(truth.end(), run.pixels, run.truth);
    depth.insert(depth.end(), run.pixels, run.has_depth ? 1 : 0);
  }
  return OverlapTable(labels, truth, depth);
}

}  // namespace epcc::test
