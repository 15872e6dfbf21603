// SPDX-License-Identifier: BSD-3-Clause
// The relative pose that two depth images themselves speak for: a reference where given poses may be wrong.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "epcc_segmentation/sensor_model.h"
#include "eval/measures/repeatability.h"

namespace epcc {

/// How badly two depth images fit each other at a relative pose, see alignDepth(): the mean robust square of their
/// differences in standard deviations, below 1 where nothing but noise differs. A place that only one image shows
/// counts as ten.
double depthMisfit(const PosedView& from, const PosedView& to, const SensorModel& sensor,
                   const Eigen::Isometry3d& to_from);

struct DepthAlignment {
  Eigen::Isometry3d to_from = Eigen::Isometry3d::Identity();  ///< first camera's coordinates into the second's
  double misfit = 0.0;                                        ///< depthMisfit() there
};

/// The pose at which what `from` shows looks most like what `to` shows: some ten thousand pixels, on planes or not, are
/// carried over, and their inverse depth compared with the one seen there, in standard deviations of the sensor
/// (Levenberg-Marquardt, Cauchy's weights, first with four times the sigma). A place that only one image shows costs
/// the same wherever it falls. From each start it goes to the next minimum, within some centimetres and degrees, and
/// takes the best of them, so that no start is favoured; along what the images leave open it stays where it was.
/// std::invalid_argument without a start.
DepthAlignment alignDepth(const PosedView& from, const PosedView& to, const SensorModel& sensor,
                          const std::vector<Eigen::Isometry3d>& starts);

}  // namespace epcc
