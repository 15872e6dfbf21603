// SPDX-License-Identifier: BSD-3-Clause
// The inputs of epcc_segment: which frames are meant, and reading one of them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "datasets/sources/frame_source.h"
#include "datasets/support/input_error.h"
#include "eval/segment/segment_options.h"

namespace epcc {

/// A frame to segment: a file, or one of a data set.
struct SegmentInput {
  std::string path;         ///< of the depth image or cloud
  std::string name;         ///< "X" of X_depth.png, X.png or X.pcd; outputs in --out are named after it
  std::string camera_file;  ///< of a depth image that is no part of a data set; empty: the numbers of the command line
  bool is_cloud = false;    ///< a cloud that is no part of a data set
  std::shared_ptr<const FrameSource> source;  ///< the data set, if it is one's
  std::size_t index = 0;                      ///< in the data set
  std::optional<InputError> problem;          ///< why it cannot be used
};

/// What the INPUTs stand for.
struct InputList {
  std::vector<SegmentInput> inputs;
  bool several = false;  ///< more than one INPUT, or a data set
  std::string usage_problem;
};

/// Lists the frames behind the INPUTs without reading them. A depth image without a camera is a usage problem if it is
/// the only input, and so are a camera for a data set that brings its own and options that no input has a use for.
/// Throws InputError if --camera names no camera.
InputList listInputs(const SegmentOptions& options);

/// Reads one input. Throws InputError.
LabelledFrame loadInput(const SegmentInput& input, const SegmentOptions& options);

}  // namespace epcc
