// SPDX-License-Identifier: BSD-3-Clause
// The noise of real frames beside the stereo noise on the same planes, as Markdown.
#pragma once

#include <string>

namespace epcc {

/// Frames whose "noise" is realsense-registered and all others make two groups, each with its own pair of tables.
/// Throws InputError if the folder or a frame cannot be used.
std::string noiseReport(const std::string& folder);

}  // namespace epcc
