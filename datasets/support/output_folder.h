// SPDX-License-Identifier: BSD-3-Clause
// Folders that outputs go to.
#pragma once

#include <string>

namespace epcc {

/// Makes the folder, and those above it, unless it is there. OutputError if that cannot be done.
void makeOutputFolder(const std::string& folder);

}  // namespace epcc
