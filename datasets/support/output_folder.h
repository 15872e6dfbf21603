// SPDX-License-Identifier: BSD-3-Clause
// Folders that outputs go to.
#pragma once

#include <string>
#include <vector>

namespace epcc {

/// Makes the folder, and those above it, unless it is there. OutputError if that cannot be done.
void makeOutputFolder(const std::string& folder);

/// The same, and OutputError if one of these files cannot be written in it: told before the work, not after it.
void makeOutputFolder(const std::string& folder, const std::vector<std::string>& files);

}  // namespace epcc
