// SPDX-License-Identifier: BSD-3-Clause
// The ABW structured-light images of the SegComp comparison as distributed: NAME.range and NAME.gt-seg.
#pragma once

#include <string>
#include <vector>

#include "datasets/sources/named_frames.h"

namespace epcc {

/// True if the folder has a NAME.range that is a Sun raster.
bool isAbwFolder(const std::string& folder);

/// Frames NAME.range in the order of their numbers; those without NAME.gt-seg are unlabelled.
class AbwFolder : public NamedFrames {
 public:
  /// Throws InputError for a folder that cannot be listed or has no frame.
  explicit AbwFolder(const std::string& folder);
  std::vector<std::string> files(std::size_t index) const override;
  LabelledFrame read(std::size_t index) const override;
};

}  // namespace epcc
