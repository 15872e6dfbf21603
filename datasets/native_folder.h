// SPDX-License-Identifier: BSD-3-Clause
// A folder of native labelled frames as a data set.
#pragma once

#include <string>
#include <vector>

#include "datasets/frame_source.h"

namespace epcc {

/// A folder of native labelled frames, in the order of their names; the data set is named after the folder.
class NativeFolder : public FrameSource {
 public:
  /// Throws InputError for a folder that cannot be listed or has no frame.
  explicit NativeFolder(const std::string& folder);
  const std::string& dataset() const override { return dataset_; }
  std::size_t size() const override { return names_.size(); }
  std::string name(std::size_t index) const override { return names_.at(index); }
  LabelledFrame read(std::size_t index) const override;

 private:
  std::string folder_;
  std::string dataset_;
  std::vector<std::string> names_;
};

}  // namespace epcc
