// SPDX-License-Identifier: BSD-3-Clause
// Organized PCD clouds as frames, with the labels of the field "label" or SynPEB's "intensity" if there are any.
#pragma once

#include <string>
#include <vector>

#include "datasets/sources/named_frames.h"

namespace epcc {

/// Reads a .pcd with its labels.
/// Field `label`: 0 no plane, 1..65534 plane, 65535 ignore, larger (PCL's "none") no plane.
/// Field `intensity` (SynPEB): 10..65534 plane, all else is no plane of the data set and becomes "ignore"; the noise
/// named is that data set's, 10 mm at every range. Intensities that are no whole numbers were measured: they are no
/// labels. With neither field the frame is unlabelled.
LabelledFrame readLabelledCloud(const std::string& path);

/// A folder of such clouds, in the order of the numbers in their names.
class LabelledCloudFolder : public NamedFrames {
 public:
  /// Throws InputError for a folder that cannot be listed or has no cloud.
  explicit LabelledCloudFolder(const std::string& folder);
  std::vector<std::string> files(std::size_t index) const override { return {path(index, ".pcd")}; }
  LabelledFrame read(std::size_t index) const override { return readLabelledCloud(path(index, ".pcd")); }
};

}  // namespace epcc
