// SPDX-License-Identifier: BSD-3-Clause
// Repeatability over sequences of frames with poses, in one pass and bounded memory.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "datasets/sources/reading_options.h"
#include "eval/experiment/experiment.h"
#include "eval/measures/repeatability.h"

namespace epcc {

struct SequenceOptions {
  std::string noise;      ///< sensor model, as frameSensor() takes it; empty: the frame's "noise", else auto
  std::vector<int> lags;  ///< frames, each at least 1 and once
  ReadingOptions reading = {};
};

/// What one method repeated between frames i and i + lag of a data set.
struct RepeatabilityRow {
  std::string dataset;
  std::string method;
  int lag = 0;
  Repeatability sums;
};

struct SequenceResult {
  std::vector<RepeatabilityRow> rows;  ///< by data set, method and lag, in the order given
  std::vector<std::string> problems;   ///< frames without pose or camera, or that cannot be read or segmented
};

/// Called with the number of frames done and to do.
using SequenceProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Takes the frames in the order of the jobs through every method; lags count the frames of the source. Each method is
/// judged with the sensor model that the frame is given, whatever it measured itself. The segmentations of the last
/// max(lags) frames are kept, nothing else. A frame with a problem keeps its place and is left out.
SequenceResult measureSequences(const FrameJobs& jobs, const std::vector<Method>& methods,
                                const SequenceOptions& options, const SequenceProgress& progress = {});

}  // namespace epcc
