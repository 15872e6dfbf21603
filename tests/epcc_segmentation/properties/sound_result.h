// SPDX-License-Identifier: BSD-3-Clause
// What holds for every result, whatever was segmented.
#pragma once

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "tests/epcc_segmentation/properties/random_frames.h"

namespace epcc::test {

/// Empty if a covariance is one: finite, and but for rounding symmetric and without a variance below zero.
template <typename Matrix>
std::string covarianceProblem(const Matrix& covariance, const std::string& of) {
  if (!covariance.allFinite()) return of + " is not finite";
  const double largest = covariance.cwiseAbs().maxCoeff();
  if (largest == 0.0) return {};
  if ((covariance - covariance.transpose()).cwiseAbs().maxCoeff() > 1e-9 * largest) return of + " is not symmetric";
  using Plain = Eigen::Matrix<double, Matrix::RowsAtCompileTime, Matrix::ColsAtCompileTime>;
  const Plain scaled = covariance / largest;  // an eigensolver is no judge of 1e-40
  const double least = Eigen::SelfAdjointEigenSolver<Plain>(scaled).eigenvalues()(0);
  if (least < -1e-9) return of + " has the eigenvalue " + std::to_string(least) + " of its largest entry";
  return {};
}

/// Empty if a plane is sound.
inline std::string planeProblem(const Plane& plane, const std::string& name) {
  const Eigen::Vector4d n = plane.coefficients;
  if (!n.allFinite()) return name + "'s coefficients are not finite";
  if (std::abs(n.head<3>().norm() - 1.0) > 1e-9) return name + "'s normal is no unit vector";
  if (n(3) < 0.0) return name + " faces away from the sensor";
  if (!plane.centroid.allFinite()) return name + "'s centroid is not finite";
  if (!(std::isfinite(plane.rms) && plane.rms >= 0.0)) return name + "'s rms is " + std::to_string(plane.rms);
  if (!(plane.confidence >= 0.0 && plane.confidence <= 1.0)) return name + "'s confidence is beyond [0, 1]";
  const std::string problem = covarianceProblem(plane.coefficients_covariance, name + "'s coefficients_covariance");
  return problem.empty() ? covarianceProblem(plane.points_covariance, name + "'s points_covariance") : problem;
}

/// Empty if a line segment is sound.
inline std::string segmentProblem(const LineSegment& segment, const PlaneSegmentation& result) {
  const bool is_row = segment.scan == ScanDirection::Rows;
  const int lines = is_row ? result.height : result.width, places = is_row ? result.width : result.height;
  const std::string name = "a segment of line " + std::to_string(segment.line);
  if (segment.line < 0 || segment.line >= lines || segment.first < 0 || segment.last < segment.first ||
      segment.last >= places)
    return name + " is outside of the image";
  if (segment.samples < 1 || segment.samples > segment.last - segment.first + 1) return name + " has too many samples";
  if (segment.label < 0 || segment.label > static_cast<std::int32_t>(result.planes.size()))
    return name + " has a label of no plane";
  if (!(std::isfinite(segment.variance) && segment.variance >= 0.0)) return name + "'s variance is no variance";
  if (!segment.start.allFinite() || !segment.end.allFinite() || !segment.mean.allFinite() || !segment.theta.allFinite())
    return name + " is not finite";
  const std::string problem = covarianceProblem(segment.covariance, name + "'s covariance");
  return problem.empty() ? covarianceProblem(segment.theta_covariance, name + "'s theta_covariance") : problem;
}

/// Empty if labels, planes and segments are sound and agree: a label is one of a plane, only valid pixels have one, no
/// plane is without, and each counts its pixels; the largest comes first.
inline std::string resultProblem(const PlaneSegmentation& result, const RandomFrame& frame) {
  if (result.width != frame.spec.width || result.height != frame.spec.height) return "the size is another";
  if (result.labels.size() != static_cast<std::size_t>(result.width * result.height)) return "labels are missing";
  std::vector<std::size_t> counts(result.planes.size() + 1, 0);
  for (std::size_t i = 0; i < result.labels.size(); ++i) {
    const std::int32_t label = result.labels[i];
    if (label < 0 || label > static_cast<std::int32_t>(result.planes.size())) return "a label is of no plane";
    if (label > 0 && !frame.isValid(i)) return "pixel " + std::to_string(i) + " is not valid and has a label";
    ++counts[static_cast<std::size_t>(label)];
  }
  for (std::size_t k = 0; k < result.planes.size(); ++k) {
    const std::string name = "plane " + std::to_string(k + 1);
    if (counts[k + 1] == 0) return name + " has no pixel";
    if (counts[k + 1] != result.planes[k].pixel_count) return name + " counts other pixels than it has";
    if (k > 0 && counts[k] < counts[k + 1]) return name + " is larger than the one before it";
    const std::string problem = planeProblem(result.planes[k], name);
    if (!problem.empty()) return problem;
  }
  for (const LineSegment& segment : result.segments) {
    const std::string problem = segmentProblem(segment, result);
    if (!problem.empty()) return problem;
  }
  return {};
}

}  // namespace epcc::test
