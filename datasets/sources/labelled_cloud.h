// SPDX-License-Identifier: BSD-3-Clause
// Organized PCD clouds with labels: the field "label", or SynPEB's "intensity".
#pragma once

#include <string>

#include "datasets/sources/named_frames.h"

namespace epcc {

/// Reads NAME.pcd: `scan` holds the points, `depth` their ranges (a scan) or distances along the optical axis (a
/// camera's cloud).
/// Field `label`: 0 no plane, 1..65534 plane, 65535 ignore, larger (PCL's "none") no plane.
/// Field `intensity` (SynPEB): 10..65534 plane, all else is no plane of the data set and becomes "ignore"; the noise
/// named is that data set's, 10 mm at every range.
LabelledFrame readLabelledCloud(const std::string& folder, const std::string& name);

/// A folder of such clouds, in the order of their names.
class LabelledCloudFolder : public NamedFrames {
 public:
  /// Throws InputError for a folder that cannot be listed or has no cloud.
  explicit LabelledCloudFolder(const std::string& folder);
  LabelledFrame read(std::size_t index) const override { return readLabelledCloud(folder(), name(index)); }
};

}  // namespace epcc
