// SPDX-License-Identifier: BSD-3-Clause
// The files epcc_segment writes for one input.
#pragma once

#include <string>
#include <vector>

#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"
#include "eval/segment/segment_input.h"
#include "eval/segment/segment_options.h"

namespace epcc {

/// Paths to write for one input; empty ones are not wanted.
struct OutputPaths {
  std::string labels;
  std::string planes;
  std::string overlay;
  std::string cloud;
  std::string segments;
  std::string segments_picture;
  std::string mesh;
  std::string polygons;

  std::vector<std::string> all() const;
};

/// The paths named by the options, or those in the --out folder.
OutputPaths outputPaths(const SegmentOptions& options, const SegmentInput& input);

/// Empty if the outputs endanger neither each other nor any input, else what is wrong in words.
std::string checkOutputs(const SegmentOptions& options, const std::vector<SegmentInput>& inputs);

/// Before any of them is written: throws OutputError where one of the paths cannot be.
void refuseSpecialFiles(const OutputPaths& paths);

/// How surfaces are made and written.
struct SurfaceStyle {
  SensorModel sensor;
  bool mesh_is_text = false;
};

/// Writes them, each under its final name only once it is complete. Throws OutputError.
void writeOutputs(const OutputPaths& paths, const LabelledFrame& input, const PlaneSegmentation& result,
                  const SurfaceStyle& surfaces);

}  // namespace epcc
