// SPDX-License-Identifier: BSD-3-Clause
// The case that a property is tried on, for when it ends the program: rapidcheck prints those that merely fail.
#pragma once

#include <string>

namespace epcc::test {

/// Told on standard error if a signal ends the program.
void noteCase(const std::string& text);

}  // namespace epcc::test
