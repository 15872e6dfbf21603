// SPDX-License-Identifier: BSD-3-Clause
// A folder whose frames are known by name.
#pragma once

#include <string>
#include <vector>

#include "datasets/sources/frame_source.h"

namespace epcc {

/// What data sets of one folder have in common; the data set is named after the folder.
class NamedFrames : public FrameSource {
 public:
  const std::string& dataset() const override { return dataset_; }
  std::size_t size() const override { return names_.size(); }
  std::string name(std::size_t index) const override { return names_.at(index); }

 protected:
  /// InputError if there are no names: the folder has no `kind`.
  NamedFrames(const std::string& folder, std::vector<std::string> names, const std::string& kind);
  const std::string& folder() const { return folder_; }
  /// FOLDER/NAME and `ending`, whose extension may be in capitals.
  std::string path(std::size_t index, const std::string& ending) const;

 private:
  std::string folder_;
  std::string dataset_;
  std::vector<std::string> names_;
};

}  // namespace epcc
