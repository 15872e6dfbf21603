// SPDX-License-Identifier: BSD-3-Clause
// The SynPEB data set: rendered spherical laser scans as organized PCD, labels in the field "intensity".
#pragma once

#include <string>
#include <vector>

#include "datasets/labelled_frame.h"

namespace epcc {

/// Names of the scans NAME.pcd of a folder, sorted; InputError if it cannot be listed.
std::vector<std::string> listSynpebScans(const std::string& folder);
/// Reads a scan: `scan` holds the points, `depth` their ranges. Labels below 10 are no planes of the data set and
/// become "ignore". The noise named is the data set's, 10 mm at every range.
LabelledFrame readSynpebScan(const std::string& folder, const std::string& name);

}  // namespace epcc
