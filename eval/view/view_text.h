// SPDX-License-Identifier: BSD-3-Clause
// The texts of the window: what is shown, the parameters, the numbers of the selected plane.
#pragma once

#include <string>

#include "eval/view/view_session.h"

namespace epcc {

/// Lines of plain ASCII, for a font with letters of one width.
struct ViewTexts {
  std::string top;     ///< the input and how it was segmented, with the parameters; or the help
  std::string bottom;  ///< the selected plane, or how to select one
};

ViewTexts viewTexts(const ViewSession& session);

}  // namespace epcc
