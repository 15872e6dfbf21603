// SPDX-License-Identifier: BSD-3-Clause
// Axes first, then cameras by resectioning, then scanners by descent; and other sizes of a cloud that nothing explains.
#include "geometry/hypothesis_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/resectioning.h"
#include "geometry/scanner_pose.h"

namespace epcc {

namespace {

constexpr std::size_t kFewestPoints = 32;
constexpr std::size_t kFewestLines = 4;
// A simple pose that is half as good as the best found is taken before it.
constexpr double kAsGood = 2.0;
// The place of a scanner, in sizes of the cloud from its middle: from farther its rays are parallel.
constexpr double kFarthestScanner = 30.0;
constexpr int kMostShuffledRings = 128;  // of a scanner; where there are more, they are in order
constexpr int kLargestSide = 1 << 28;    // that can be multiplied
constexpr int kMostPieces = 4;           // of a row, where the width is wrong

/// A reflection of the cloud's axes onto the sensor's, forward or up being one of the cloud's.
Eigen::Matrix3d permutation(int third, bool negative, bool swapped) {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
  const int next = (third + 1) % 3, last = (third + 2) % 3;
  axes(swapped ? last : next, 0) = 1.0;
  axes(swapped ? next : last, 1) = 1.0;
  axes(third, 2) = negative ? -1.0 : 1.0;
  return axes;
}

}  // namespace

Choice plainChoice(Projection projection) {
  Choice choice;
  choice.is_plain = true;
  choice.projection = projection;
  choice.pose.is_scanner = projection == Projection::Spherical;
  if (projection == Projection::PerspectiveBackward) choice.pose.axes = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  return choice;
}

bool HypothesisSearch::tellsGeometry() const {
  return lattice.points().size() >= kFewestPoints && lattice.rows().size() >= kFewestLines &&
         lattice.columns().size() >= kFewestLines;
}

void HypothesisSearch::measureSize() {
  const auto n = static_cast<double>(lattice.points().size());
  middle_.setZero();
  for (const PointLattice::Point& point : lattice.points()) middle_ += point.p / n;
  size_ = 0.0;
  for (const PointLattice::Point& point : lattice.points()) size_ += (point.p - middle_).norm() / n;
}

void HypothesisSearch::consider(Choice choice, const CloudOptions& options, Choice& best) {
  if (options.sensor != CloudOptions::Sensor::Any &&
      (options.sensor == CloudOptions::Sensor::Scanner) != choice.pose.is_scanner)
    return;
  if (choice.pose.is_scanner && (choice.pose.origin - middle_).norm() > kFarthestScanner * size_) return;
  choice.residual = tables.residual(lattice, choice.pose);
  if (kAsGood * choice.residual < best.residual) best = choice;
}

void HypothesisSearch::considerAxes(const SensorPose& from, const CloudOptions& options, Choice& best) {
  for (int third = 0; third < 3; ++third)
    for (const bool other : {false, true}) {
      Choice choice;
      choice.pose.origin = from.origin;
      choice.pose.is_scanner = true;
      choice.pose.axes = from.axes * axesAbout(Eigen::Vector3d::Unit(third));
      choice.pose.rings_are_columns = other;
      consider(choice, options, best);
      choice.pose.is_scanner = choice.pose.rings_are_columns = false;
      for (const bool swapped : {false, true}) {
        choice.pose.axes = from.axes * permutation(third, other, swapped);
        consider(choice, options, best);
      }
    }
}

void HypothesisSearch::considerCameras(const CloudOptions& options, Choice& best) {
  for (const bool at_origin : {true, false}) {
    const auto pose = at_origin ? cameraAtOrigin(lattice) : cameraAnywhere(lattice);
    Choice choice;
    if (!pose) continue;
    choice.pose = *pose;
    consider(choice, options, best);
  }
}

void HypothesisSearch::considerSearch(const CloudOptions& options, Choice& best) {
  considerCameras(options, best);
  if (options.sensor != CloudOptions::Sensor::Camera && best.residual > kClearResidual) considerScanners(options, best);
}

void HypothesisSearch::considerScanners(const CloudOptions& options, Choice& best) {
  for (const bool rings_are_columns : {false, true}) {
    std::array<PoseHypothesis, 3> starts{scannerAt(lattice, Eigen::Vector3d::Zero(), rings_are_columns),
                                         scannerFromColumns(lattice, rings_are_columns), PoseHypothesis()};
    if (options.viewpoint) starts[2] = scannerAt(lattice, options.viewpoint->origin, rings_are_columns);
    for (const PoseHypothesis& start : starts) {
      if (!start.is_scanner) continue;
      Choice choice;
      choice.pose = start;
      choice.residual = tables.residual(lattice, choice.pose);
      consider(choice, options, best);
      if (best.residual <= kClearResidual) return;
      refineScanner(lattice, choice.pose);
      consider(choice, options, best);
      if (best.residual <= kClearResidual) return;
    }
  }
}

bool HypothesisSearch::repeatsRings(const CloudView& cloud, const CloudOptions& options, const PoseHypothesis& pose) {
  tables.residual(lattice, pose);
  if (goesOn(tables.ringElevation())) return false;
  if ((pose.rings_are_columns ? cloud.width : cloud.height) > kMostShuffledRings) return true;
  all_rings_.read(cloud, pose.rings_are_columns ? kFewLines : kMostShuffledRings,
                  pose.rings_are_columns ? kMostShuffledRings : kFewLines, options.invalid, other_markers);
  tables.residual(all_rings_, pose);
  return tables.repeatsRings();
}

std::string HypothesisSearch::wrongSize(const CloudView& cloud, const CloudOptions& options) {
  const int w = cloud.width, h = cloud.height;
  if (std::max(w, h) > kLargestSide) return {};
  Choice best;
  std::string size_of_best;
  const auto look = [&](int width, int height) {
    const CloudView other{cloud.xyz, cloud.stride, width, height};
    lattice.read(other, kFewLines, kFewLines, options.invalid, other_markers);
    if (!tellsGeometry()) return;
    measureSize();
    Choice found;
    considerAxes(SensorPose(), options, found);
    considerCameras(options, found);
    if (!(found.residual <= kMaxResidual && found.residual < best.residual)) return;
    if (found.pose.is_scanner && repeatsRings(other, options, found.pose)) return;
    best = found;
    size_of_best = std::to_string(width) + "x" + std::to_string(height);
  };
  look(h, w);
  for (int k = 2; k <= kMostPieces; ++k) {
    if (h % k == 0) look(w * k, h / k);
    if (w % k == 0) look(w / k, h * k);
  }
  if (size_of_best.empty()) return {};
  return "; as " + size_of_best + " they would be a " + (best.pose.is_scanner ? "scanner" : "camera") +
         "'s: its width is likely wrong";
}

}  // namespace epcc
