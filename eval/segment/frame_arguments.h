// SPDX-License-Identifier: BSD-3-Clause
// The options that epcc_segment shares with other programs that segment frames: inputs, camera, reading, method.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/program/reading_arguments.h"
#include "eval/segment/segment_options.h"

namespace epcc {

/// The options as typed, before they are checked against each other.
struct FrameArguments {
  std::optional<double> fx, fy, cx, cy, depth_scale;
  std::string mode = "inverse-depth";
  std::vector<std::string> assignments;
  ReadingArguments reading;
  std::string scan;  ///< empty: the mode's own
  std::optional<double> line_k_max, plane_k_max, max_gap;
  std::optional<int> min_points;
  std::string criterion;
  std::optional<std::string> plane_weight;
};

/// Adds INPUT..., described by `inputs`, and all groups of options but those of a program's own, and a short help.
/// `options` and `arguments` must outlive the reading of the command line.
void addFrameArguments(CLI::App& app, const std::string& inputs, SegmentOptions& options, FrameArguments& arguments);

/// Puts what was typed into the options, once the command line was read. Empty if all is well, else what is wrong.
std::string setFrameOptions(const FrameArguments& arguments, SegmentOptions& options);

}  // namespace epcc
