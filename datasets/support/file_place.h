// SPDX-License-Identifier: BSD-3-Clause
// Where a file is, whatever it is called: for checks that no output takes the place of an input.
#pragma once

#include <filesystem>
#include <string>

namespace epcc {

/// Absolute, without links, "." and "..": the same file has the same place, whether it exists or not.
std::filesystem::path filePlace(const std::string& path);

/// Whether a file is in the folder or anywhere below it, or is that folder.
bool isWithin(const std::string& file, const std::string& folder);

}  // namespace epcc
