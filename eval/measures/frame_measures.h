// SPDX-License-Identifier: BSD-3-Clause
// Every measure of one segmentation against the ground truth of its frame.
#pragma once

#include "datasets/files/labelled_frame.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "eval/measures/instance_measures.h"
#include "eval/measures/paper_measures.h"
#include "eval/measures/plane_errors.h"
#include "eval/measures/segcomp_measures.h"

namespace epcc {

/// Whole numbers of one frame or, added up, of many.
struct FrameMeasures {
  PaperMeasures paper;
  SegcompMeasures segcomp;
  InstanceMeasures instances;
  PlaneErrorSums planes;

  FrameMeasures& operator+=(const FrameMeasures& other);
};

/// Overlaps of the segmentation with the frame's labels. Throws std::invalid_argument if the sizes differ.
OverlapTable overlapTable(const LabelledFrame& frame, const PlaneSegmentation& segmentation);

FrameMeasures measureFrame(const LabelledFrame& frame, const PlaneSegmentation& segmentation);

}  // namespace epcc
