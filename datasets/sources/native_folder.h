// SPDX-License-Identifier: BSD-3-Clause
// A folder of native labelled frames, depth images and scans, as a data set.
#pragma once

#include <string>
#include <vector>

#include "datasets/sources/named_frames.h"

namespace epcc {

/// A folder of native labelled frames, in the order of the numbers in their names.
class NativeFolder : public NamedFrames {
 public:
  /// Throws InputError for a folder that cannot be listed or has no frame.
  explicit NativeFolder(const std::string& folder);
  std::vector<std::string> files(std::size_t index) const override;
  LabelledFrame read(std::size_t index) const override;
};

}  // namespace epcc
