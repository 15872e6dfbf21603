// SPDX-License-Identifier: BSD-3-Clause
// The frames of a run that are doubtful, told once for each data set.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "eval/experiment/experiment.h"

namespace epcc {

/// Counts them, and keeps what is said of the first.
class DoubtfulFrames {
 public:
  struct OfDataset {
    std::string dataset;
    std::size_t frames = 0;
    std::string first;  ///< frame
    std::string doubt;  ///< about it
  };

  /// What all methods did on one frame.
  void add(const std::vector<FrameRecord>& records);
  /// In the order in which data sets are first doubted.
  const std::vector<OfDataset>& all() const { return all_; }
  /// "DATASET: 5 frames are doubtful; FRAME: what is said of the first".
  std::vector<std::string> lines() const;

 private:
  std::vector<OfDataset> all_;
};

}  // namespace epcc
