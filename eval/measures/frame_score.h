// SPDX-License-Identifier: BSD-3-Clause
// How well a method did on a frame, as one number to sort by.
#pragma once

#include "eval/measures/frame_measures.h"

namespace epcc {

/// 2 correct / (N + IC): 1 if every surface is found at 80 % overlap and nothing else; compared in whole numbers.
struct FrameScore {
  long part = 1;
  long whole = 1;  ///< positive

  FrameScore() = default;
  explicit FrameScore(const FrameMeasures& m)
      : part(2 * m.segcomp.correct), whole(m.paper.surfaces + m.paper.clusters) {
    // Where nothing was to be found and nothing was.
    if (whole == 0) part = whole = 1;
  }
  /// Sorts the other way round.
  FrameScore reversed() const {
    FrameScore score = *this;
    score.part = -part;
    return score;
  }
  bool operator<(const FrameScore& other) const { return part * other.whole < other.part * whole; }
};

}  // namespace epcc
