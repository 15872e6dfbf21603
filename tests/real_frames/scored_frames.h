// SPDX-License-Identifier: BSD-3-Clause
// Real labelled frames, segmented and compared with their ground truth.
#pragma once

#include <string>
#include <vector>

#include "datasets/files/labelled_frame.h"
#include "epcc_segmentation/parameters.h"
#include "eval/measures/paper_measures.h"
#include "eval/measures/segcomp_measures.h"

namespace epcc::test {

/// What became of one frame.
struct FrameScore {
  std::string name;
  std::string problem;  ///< empty, or what went wrong
  PaperMeasures paper;
  SegcompMeasures segcomp;        ///< at 0.8
  double largest_coverage = 0.0;  ///< of the largest surface, by the clusters that it dominates
  std::int32_t largest_surface = 0;
  double largest_share = 0.0;  ///< of the frame's scored pixels
};

/// Segments with the sensor model that the frame's JSON names.
FrameScore scoreFrame(const LabelledFrame& frame, const Parameters& parameters);
/// All frames of a data set; an unreadable one has its problem stated.
std::vector<FrameScore> scoreFolder(const std::string& folder, const Parameters& parameters);

}  // namespace epcc::test
