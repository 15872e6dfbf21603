// SPDX-License-Identifier: BSD-3-Clause
// The ABW structured-light images of the SegComp comparison as distributed: NAME.range and NAME.gt-seg.
#pragma once

#include <string>
#include <vector>

#include "datasets/frame_source.h"

namespace epcc {

/// True if the folder has a NAME.range that is a Sun raster.
bool isAbwFolder(const std::string& folder);

/// Frames NAME.range in the order of their numbers; those without NAME.gt-seg are unlabelled.
class AbwFolder : public FrameSource {
 public:
  /// Throws InputError for a folder that cannot be listed or has no frame.
  explicit AbwFolder(const std::string& folder);
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
