// SPDX-License-Identifier: BSD-3-Clause
// The cases of epcc_bench and their names: METHOD/PLACE or METHOD/PLACE/VARIANT, PLACE is WxH or frames/NAME.
#pragma once

#include <string>

namespace epcc::bench {

/// Registers those of the rendered frames.
void addRenderedCases();
/// Registers those of the frames of a folder. Throws InputError.
void addFolderCases(const std::string& folder);

}  // namespace epcc::bench
