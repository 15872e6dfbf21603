// SPDX-License-Identifier: BSD-3-Clause
// Whether there is a display that VTK can draw on, asked before VTK ends the program over it.
#pragma once

#include <string>

namespace epcc {

/// Empty if there is one, else what is wrong and what to do, in words. Debian's VTK needs an X display with GLX, also
/// for pictures that no window shows.
std::string displayProblem();

}  // namespace epcc
