// SPDX-License-Identifier: BSD-3-Clause
// How far a trajectory is from the true one, as the tools of the TUM RGB-D benchmark define it (Sturm et al., IROS
// 2012).
#pragma once

#include <cstddef>
#include <vector>

#include "datasets/files/trajectory_file.h"

namespace epcc {

/// Of some errors; all 0 if there is none.
struct ErrorStatistics {
  std::size_t count = 0;
  double rmse = 0.0, mean = 0.0, median = 0.0, max = 0.0;
};
ErrorStatistics errorStatistics(const std::vector<double>& errors);

/// A shift and an angle: those of E = A B^-1.
struct PoseDifference {
  double metres = 0.0, degrees = 0.0;
};
PoseDifference poseDifference(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b);

struct RelativePoseErrors {
  ErrorStatistics metres;
  ErrorStatistics degrees;
};

/// Relative pose error (evaluate_rpe.py with --fixed_delta, all pairs): for each pose the one nearest to `seconds`
/// later, but not the last of the trajectory; the truth at both times is the pose nearest in time, at most twice the
/// truth's median interval away. E = (Pi^-1 Pj) (Qi^-1 Qj)^-1, its shift and its angle, Q the truth. With `counts`,
/// which has a value for each pose of the estimate, pairs count of which both poses do.
RelativePoseErrors relativePoseErrors(const Trajectory& estimate, const Trajectory& truth, double seconds = 1.0,
                                      const std::vector<bool>& counts = {});

/// Absolute trajectory error (evaluate_ate.py): distances of the positions, metres, once a turn and a shift, no scale,
/// have laid the estimate onto the truth with the least squared sum. The truth of a pose is the one nearest in time, if
/// it is not more than `tolerance` seconds away; a pose without one is left out. Fewer than three: no errors.
ErrorStatistics absoluteTrajectoryErrors(const Trajectory& estimate, const Trajectory& truth,
                                         double tolerance = kMaxTimeDifference);

}  // namespace epcc
