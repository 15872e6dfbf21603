// SPDX-License-Identifier: BSD-3-Clause
// Inputs in memory for tests of what epcc_view shows.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "eval/segment/segment_input.h"
#include "tests/support/tiny_frames.h"

namespace epcc::test {

/// Frames as inputs of one data set.
inline std::vector<SegmentInput> inputsOf(std::vector<LabelledFrame> frames) {
  const auto source = std::make_shared<MemorySource>("frames", std::move(frames));
  std::vector<SegmentInput> inputs(source->size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    inputs[i].path = inputs[i].name = source->name(i);
    inputs[i].source = source;
    inputs[i].index = i;
  }
  return inputs;
}

/// Three frames of a room's corner: "room0" to "room2".
inline std::vector<SegmentInput> roomInputs() {
  std::vector<LabelledFrame> frames;
  for (unsigned seed = 0; seed < 3; ++seed) frames.push_back(tinyFrame("room" + std::to_string(seed), seed));
  return inputsOf(std::move(frames));
}

}  // namespace epcc::test
