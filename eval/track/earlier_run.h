// SPDX-License-Identifier: BSD-3-Clause
// What an earlier run has left in the folder of the outputs.
#pragma once

#include <string>
#include <vector>

namespace epcc {

/// The label images in a folder are those of one run: the same number is the same surface in all of them. So nothing of
/// another run may stay beside them, and nothing is removed but what this run makes anew.
///
/// The first picture of labels in the folder that is of none of these frames; empty if there is none.
std::string foreignPicture(const std::string& folder, const std::vector<std::string>& frames);

/// Paths of the files that speak of a whole run.
std::vector<std::string> filesOfRun(const std::string& folder);

/// Removes the pictures of these frames, and the files that speak of a whole run.
void removeEarlierRun(const std::string& folder, const std::vector<std::string>& frames);

}  // namespace epcc
