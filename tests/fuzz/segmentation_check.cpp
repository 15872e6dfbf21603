// SPDX-License-Identifier: BSD-3-Clause
// Every promise of plane_segmentation.h that can be checked without knowing the scene.
#include "tests/fuzz/segmentation_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/fuzz/require.h"

namespace epcc::fuzz {
namespace {

template <typename Matrix>
void checkCovariance(const Matrix& covariance) {
  require(covariance.allFinite(), "a covariance is finite");
  const double largest = covariance.cwiseAbs().maxCoeff();
  require((covariance - covariance.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * largest, "a covariance is symmetric");
  require(covariance.diagonal().minCoeff() >= 0.0, "no variance is negative");
}

void checkSegment(const LineSegment& segment, std::size_t planes) {
  require(segment.first >= 0 && segment.first <= segment.last, "a segment has its samples in order");
  require(segment.label >= 0 && static_cast<std::size_t>(segment.label) <= planes, "a segment's plane exists");
  require(segment.start.allFinite() && segment.end.allFinite() && segment.mean.allFinite(), "a segment is finite");
  require(std::isfinite(segment.variance) && segment.variance >= 0.0, "a segment's variance is one");
  checkCovariance(segment.covariance);
  require(segment.theta.allFinite(), "a segment's line is finite");
  checkCovariance(segment.theta_covariance);
}

}  // namespace

void checkPlane(const Plane& plane, const Eigen::Vector3d& sensor) {
  require(plane.coefficients.allFinite(), "coefficients are finite");
  require(std::abs(plane.coefficients.head<3>().norm() - 1.0) < 1e-6, "a normal has length 1");
  const double size = 1.0 + sensor.norm() + std::abs(plane.coefficients(3));
  require(plane.signedDistance(sensor) >= -1e-9 * size, "a normal points to the sensor");
  require(plane.centroid.allFinite(), "a centroid is finite");
  require(std::isfinite(plane.rms) && plane.rms >= 0.0, "an rms is one");
  require(plane.confidence >= 0.0 && plane.confidence <= 1.0, "a confidence is from 0 to 1");
  checkCovariance(plane.coefficients_covariance);
  checkCovariance(plane.points_covariance);
}

void checkSegmentation(const DepthFrame& frame, const PlaneSegmentation& result) {
  require(result.width == frame.width() || frame.isTransposed(), "the width is that of the frame");
  require(result.labels.size() == static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height()),
          "there is a label for each pixel");
  std::vector<std::size_t> counts(result.planes.size() + 1, 0);
  Eigen::Vector3d point;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) {
      const std::int32_t label = result.labels[frame.index(row, column)];
      require(label >= 0 && static_cast<std::size_t>(label) < counts.size(), "a label's plane exists");
      require(label == 0 || frame.point(row, column, point), "only pixels that are measured have labels");
      ++counts[static_cast<std::size_t>(label)];
    }
  const Eigen::Vector3d sensor =
      frame.geometry() == nullptr ? Eigen::Vector3d(0.0, 0.0, 0.0) : Eigen::Vector3d(frame.geometry()->pose.origin);
  for (std::size_t k = 0; k < result.planes.size(); ++k) {
    require(result.planes[k].pixel_count == counts[k + 1], "a plane knows its pixels");
    require(counts[k + 1] > 0, "a plane has pixels");
    require(k == 0 || counts[k + 1] <= counts[k], "large planes go first");
    checkPlane(result.planes[k], sensor);
  }
  for (const LineSegment& segment : result.segments) checkSegment(segment, result.planes.size());
}

void checkFailure(Status status, const std::string& error, const PlaneSegmentation& result) {
  require(status != Status::Ok && status != Status::Failed && status != Status::OutOfMemory, "a failure is foreseen");
  requireOneLine(error);
  require(result.planes.empty() && result.segments.empty(), "a failure has no planes");
  require(std::all_of(result.labels.begin(), result.labels.end(), [](std::int32_t label) { return label == 0; }),
          "a failure has no labels");
}

void checkSame(const PlaneSegmentation& one, const PlaneSegmentation& other) {
  require(one.labels == other.labels, "labels are the same");
  require(one.planes.size() == other.planes.size(), "planes are as many");
  for (std::size_t k = 0; k < one.planes.size(); ++k) {
    require(one.planes[k].coefficients == other.planes[k].coefficients, "coefficients are the same");
    require(one.planes[k].coefficients_covariance == other.planes[k].coefficients_covariance,
            "covariances are the same");
    require(one.planes[k].rms == other.planes[k].rms, "residuals are the same");
  }
  require(one.segments.size() == other.segments.size(), "segments are as many");
}

}  // namespace epcc::fuzz
