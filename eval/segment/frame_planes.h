// SPDX-License-Identifier: BSD-3-Clause
// One input that has been read, segmented as the command line says: for all programs that show planes.
#pragma once

#include <string>

#include "datasets/files/labelled_frame.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/plane_extractor.h"
#include "eval/program/frame_sensor.h"
#include "eval/segment/segment_input.h"

namespace epcc {

/// The sensor model for an input's frame, see frameSensor(). `noise` as --noise takes it.
FrameSensor sensorOf(const SegmentInput& input, const LabelledFrame& frame, const std::string& noise);

/// Planes of the frame; what makes them doubtful, its file included, is in result.doubts. A sensor that was measured on
/// the frame is not adapted to it again. Throws InputError naming the input.
void findPlanes(const SegmentInput& input, const LabelledFrame& frame, const FrameSensor& sensor,
                const Parameters& parameters, PlaneExtractor& extractor, PlaneSegmentation& result);

}  // namespace epcc
