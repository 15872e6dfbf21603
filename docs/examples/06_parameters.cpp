// SPDX-License-Identifier: BSD-3-Clause
// Parameters: as fields, by name, and those of the paper mode.
#include <epcc_segmentation/parameter_table.h>
#include <epcc_segmentation/plane_extractor.h>

#include <cstdio>

#include "room.h"

int main() {
  const epcc::PinholeCamera camera = example::camera();
  const std::vector<float> depth = example::depthOfRoom();
  const epcc::DepthFrame frame = epcc::DepthFrame::fromDepth(depth.data(), camera);
  epcc::PlaneExtractor extractor;
  epcc::PlaneSegmentation result;

  // As fields. The table in docs/reference/parameters.md has the effect of each.
  epcc::Parameters parameters;
  parameters.threads = 2;
  parameters.inverse_depth.min_points = 20000;
  extractor.setParameters(parameters);
  if (!extractor.extract(frame, result)) return 1;
  std::printf("at least 20000 pixels: %zu planes\n", result.planes.size());

  // By name, as from a configuration file or the command line (epcc_segment --set NAME=VALUE).
  std::printf("\"%s\"\n", epcc::setParameter("inverse_depth.min_points=60", parameters).c_str());
  std::printf("\"%s\"\n", epcc::setParameter("inverse_depth.min_points=0", parameters).c_str());

  // The algorithm as published, with a setting of its own.
  epcc::Parameters paper = epcc::Parameters::forPaper();
  paper.paper.max_gap = 0.2;
  extractor.setParameters(paper);
  if (!extractor.extract(frame, result)) return 1;
  std::printf("paper mode: %zu planes\n", result.planes.size());

  // What is out of range shows in words when a frame is segmented.
  paper.paper.line_k_max = -1.0;
  extractor.setParameters(paper);
  if (!extractor.extract(frame, result)) std::printf("%s\n", extractor.error().c_str());
}

// Prints:
//   at least 20000 pixels: 1 planes
//   ""
//   "inverse_depth.min_points must be in [1, 1e9] pixels, not 0"
//   paper mode: 3 planes
//   paper.line_k_max must be in (0, 100] sigma, not -1
