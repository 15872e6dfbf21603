// SPDX-License-Identifier: BSD-3-Clause
// What every method did on one frame, as a small file of whole numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "eval/experiment/experiment.h"

namespace epcc {

/// A frame's results; `records` in the order of the methods, none of them without dataset, frame and method.
struct StoredFrame {
  std::size_t index = 0;  ///< in its data set
  std::string file_name;  ///< of its label images, see FrameJob
  std::vector<FrameRecord> records;
};

/// OUT/results/DATASET/THOUSANDS/REST.json: no folder holds more than a thousand entries.
std::string storedFramePath(const std::string& out, const std::string& dataset, std::size_t index);

/// Appears whole or not at all. Times are kept in whole microseconds. Throws OutputError.
void storeFrame(const std::string& out, const StoredFrame& frame);

/// Nothing if the frame has no result, one of other methods than these, of another frame than `name`, if that is given,
/// or, after a failure of the machine, a damaged one.
std::optional<StoredFrame> loadFrame(const std::string& out, const std::string& dataset, std::size_t index,
                                     const std::vector<std::string>& methods,
                                     const std::optional<std::string>& name = std::nullopt);

}  // namespace epcc
