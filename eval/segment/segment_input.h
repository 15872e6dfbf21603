// SPDX-License-Identifier: BSD-3-Clause
// The inputs of epcc_segment: which files are meant, and reading one of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "datasets/files/image.h"
#include "epcc_segmentation/depth_frame.h"
#include "eval/segment/segment_options.h"

namespace epcc {

/// A file to segment.
struct SegmentInput {
  std::string path;
  std::string name;         ///< "X" of X_depth.png, X.png or X.pcd; outputs in --out are named after it
  std::string camera_file;  ///< for a depth image; empty: the numbers of the command line
  std::string problem;      ///< not empty: why it cannot be used
  std::string problem_field;
  bool is_cloud = false;
};

/// What the INPUTs stand for.
struct InputList {
  std::vector<SegmentInput> inputs;
  bool several = false;  ///< more than one INPUT, or a folder
  std::string usage_problem;
};

/// Lists the files behind the INPUTs without reading them: folders give their frames. A depth image without a
/// camera is a usage problem if it is the only input.
InputList listInputs(const SegmentOptions& options);

/// One frame in memory.
struct LoadedFrame {
  int width = 0;
  int height = 0;
  DepthImage depth;        ///< measured value of each pixel, 0 = invalid; for pictures also of clouds
  std::vector<float> xyz;  ///< clouds only
  PinholeCamera camera;    ///< depth images only
  Projection projection = Projection::Perspective;
  std::optional<std::string> noise;  ///< preset named by the frame

  /// A view; this must outlive it.
  DepthFrame frame() const;
};

/// Reads one input. Throws InputError.
LoadedFrame loadInput(const SegmentInput& input, const SegmentOptions& options);

}  // namespace epcc
