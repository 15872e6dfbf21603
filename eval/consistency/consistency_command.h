// SPDX-License-Identifier: BSD-3-Clause
// What epcc_consistency does.
#pragma once

#include <iosfwd>

namespace epcc {

/// The whole program: command line in, exit code out.
int consistencyMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace epcc
