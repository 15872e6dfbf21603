// SPDX-License-Identifier: BSD-3-Clause
// The picture of the comparison in the layout of the paper's Fig. 21.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "eval/comparison/comparison.h"

namespace epcc {

/// The segmentation's labels renamed for comparing with the truth by eye: the largest cluster of a surface has the
/// surface's label, every other one a label of its own beyond those of the truth.
std::vector<std::int32_t> labelsAsInTruth(const LabelledFrame& frame, const PlaneSegmentation& segmentation);

/// The segmentation in the truth's colours on the depth image.
ColorImage drawAsInTruth(const LabelledFrame& frame, const PlaneSegmentation& segmentation);

/// A row a scene: depth, ground truth, region growing, RANSAC, and the method `epcc` ("epcc-paper" or "epcc").
ColorImage comparisonFigure(const Comparison& comparison, const std::string& epcc);

}  // namespace epcc
