// SPDX-License-Identifier: BSD-3-Clause
// Normalised squared errors of planes and line segments over many noisy renderings.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "epcc_segmentation/line_segment.h"
#include "epcc_segmentation/plane_segmentation.h"

namespace epcc {

/// e^T C^-1 e of the three parameters that a plane has; chi-square with 3 degrees of freedom if the covariance is
/// right.
double normalisedSquaredError(const Plane& plane, const Vector4& truth);
/// The same of a segment's theta; 2 degrees of freedom.
double normalisedSquaredError(const LineSegment& segment, const Vector2& truth);

/// What came of one error and one way to get at planes or lines.
struct ConsistencyRow {
  std::string error;              ///< RenderedError::name
  std::string labels;             ///< "exact", "segmented", "auto"
  int parameters = 3;             ///< 3 of planes, 2 of line segments
  std::vector<double> squares;    ///< normalised squared errors, ascending
  std::vector<std::string> what;  ///< of which surface, by the order in which they came; of planes alone
  std::vector<double> by_what;    ///< their normalised squared errors in that order

  double mean() const;
  double quantile(double share) const;
};

/// Every error in every scene, `runs` renderings of each: planes and lines fitted to exact labels; planes that are
/// found with the right model given, and with the sensor measured (a stream of each scene). A plane is found that has
/// 80 % of a surface and no more than a fifth besides. Throws std::runtime_error if a frame cannot be segmented.
std::vector<ConsistencyRow> runConsistency(int runs, const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace epcc
