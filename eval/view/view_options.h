// SPDX-License-Identifier: BSD-3-Clause
// The command line of epcc_view.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "eval/segment/segment_options.h"
#include "eval/view/view_scene.h"

namespace epcc {

/// What epcc_view is asked to do.
struct ViewOptions {
  SegmentOptions input;            ///< its inputs, camera, reading and method
  std::string snapshot;            ///< picture to write instead of opening a window; empty: none
  ViewStyle style = firstStyle();  ///< what is drawn at the start
  std::vector<std::string> keys;   ///< pressed before anything is shown
  int width = 1280;                ///< of window or picture, pixels
  int height = 800;
};

/// Reads the command line. Returns an exit code if the program is done (help, version, or an error that has been
/// reported on `err` in one line), nothing if `options` is to be carried out.
std::optional<int> parseViewOptions(int argc, const char* const* argv, ViewOptions& options, std::ostream& out,
                                    std::ostream& err);

}  // namespace epcc
