// SPDX-License-Identifier: BSD-3-Clause
// The Perceptron laser scans of the SegComp comparison as distributed: perc.test.N and perc.test.N.gt-seg.
#pragma once

#include <Eigen/Core>
#include <string>

#include "datasets/named_frames.h"

namespace epcc {

/// The point that pixel (row, column) of a 512x512 scan sees at `range` (0..4095), in units of the calibration: x left,
/// y up, z forward.
Eigen::Vector3d perceptronPoint(int row, int column, double range);

/// True if the folder has a scan, perc.test.N or perc.train.N.
bool isPerceptronFolder(const std::string& folder);

/// Scans in the order of their numbers; those without NAME.gt-seg are unlabelled. The files do not say how long a unit
/// of the calibration is: perceptron.json in the folder must, as "metres_per_unit".
///
/// The rows of a scan are planar sections, its columns cones. A spherical scan has it the other way round, so a frame
/// is the scan turned by a quarter: pixel (row, column) of the scan is at row `column`, column 511 - `row` of the
/// frame.
class PerceptronFolder : public NamedFrames {
 public:
  /// Throws InputError for a folder that cannot be listed, has no frame or no perceptron.json.
  explicit PerceptronFolder(const std::string& folder);
  LabelledFrame read(std::size_t index) const override;

 private:
  double metres_per_unit_ = 0.0;
};

}  // namespace epcc
