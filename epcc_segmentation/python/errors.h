// SPDX-License-Identifier: BSD-3-Clause
// The library's statuses as exceptions of Python, with the library's own words.
#pragma once

#include <string>

#include "epcc_segmentation/status.h"

namespace epcc::python {

/// Throws epcc.InputError (an EpccError and a ValueError), epcc.OutOfMemoryError (an EpccError and a MemoryError) or
/// epcc.EpccError, as fits the status. Needs the GIL.
[[noreturn]] void throwStatus(Status status, const std::string& text);
/// throwStatus() unless the text is empty: for what validate() says.
void throwProblem(Status status, const std::string& text);
/// Throws Python's TypeError.
[[noreturn]] void throwTypeError(const std::string& text);

}  // namespace epcc::python
