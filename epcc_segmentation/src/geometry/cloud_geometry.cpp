// SPDX-License-Identifier: BSD-3-Clause
// Chooses between hypotheses: simple ones first, and a search only where none of them explains the points.
#include "epcc_segmentation/cloud_geometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/point_lattice.h"
#include "geometry/ray_tables.h"
#include "geometry/resectioning.h"
#include "geometry/scan_grid.h"
#include "geometry/scanner_pose.h"

namespace epcc {

namespace {

// Rows and columns of the lattice: a few hundred points tell a camera, and scanners, whose rings may each be ahead of
// the others, are looked at ring by ring.
constexpr int kFewLines = 32;
constexpr int kManyLines = 128;
constexpr int kMostLines = 256;  // where points are few
constexpr std::size_t kEnoughPoints = 200;
constexpr std::size_t kFewestPoints = 32;
constexpr std::size_t kFewestLines = 4;

// Residuals, in deviations of all rays: 0.01 is 0.3 % of the image's side. A simple pose that is as good as this needs
// no search, and one that is half as good as the best found is taken before it. With more than the last there are no
// rays: wide lenses that were not rectified and scans sorted into bins of angle have half of it, what is no scan three
// times as much.
constexpr double kClear = 0.003;
constexpr double kAsGood = 2.0;
constexpr double kMaxResidual = 0.12;
constexpr double kAsBefore = 1.3;  // residual of the pose of the last cloud
constexpr double kSlack = 3e-4;
// The place of a scanner, in sizes of the cloud from its middle: from farther its rays are parallel.
constexpr double kFarthestScanner = 30.0;

// No camera's picture lies farther away than this in the middle, metres, and no scanner's: then the unit is the
// millimetre.
constexpr double kFarCamera = 100.0;
constexpr double kFarScanner = 1000.0;
constexpr double kMillimetre = 0.001;

struct Choice {
  PoseHypothesis pose;
  double residual = kNoRays;
  bool is_plain = false;  // a frame that DepthFrame knows
  Projection projection = Projection::Perspective;
};

Choice plainChoice(Projection projection) {
  Choice choice;
  choice.is_plain = true;
  choice.projection = projection;
  choice.pose.is_scanner = projection == Projection::Spherical;
  if (projection == Projection::PerspectiveBackward) choice.pose.axes = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  return choice;
}

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

std::string CloudOptions::validate() const {
  if (!std::isfinite(unit) || unit < 0.0) return "the unit must be positive, in metres, or 0 where it is not known";
  if (!(min_depth >= 0.0) || !(max_depth > min_depth)) return "the depths must be 0 <= min_depth < max_depth";
  if (viewpoint && !(viewpoint->axes.allFinite() && viewpoint->origin.allFinite()))
    return "the viewpoint is not finite";
  return {};
}

struct GeometryFinder::Memory {
  PointLattice lattice;
  RayTables tables;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // of the lattice's points
  double size = 0.0;                                 // their mean distance from it
  std::vector<double> distances;
  std::vector<Vector3f> other_markers;
  std::optional<Choice> last;
  CloudGeometry geometry;

  void choose(const CloudView& cloud, const CloudOptions& options);

 private:
  void consider(Choice choice, const CloudOptions& options, Choice& best);
  void considerAxes(const SensorPose& from, const CloudOptions& options, Choice& best);
  void considerSearch(const CloudOptions& options, Choice& best);
  void considerScanners(const CloudOptions& options, Choice& best);
  /// There are enough points, rows and columns to tell a camera from a scanner.
  bool tellsGeometry() const {
    return lattice.points().size() >= kFewestPoints && lattice.rows().size() >= kFewestLines &&
           lattice.columns().size() >= kFewestLines;
  }
  bool isAsBefore(const CloudOptions& options);
  void orient(Choice& choice) const;
  void describe(const CloudView& cloud, const CloudOptions& options, const Choice& best);
  void measureSize();
  double medianDistance(const PoseHypothesis& pose);
};

void GeometryFinder::Memory::consider(Choice choice, const CloudOptions& options, Choice& best) {
  if (options.sensor != CloudOptions::Sensor::Any &&
      (options.sensor == CloudOptions::Sensor::Scanner) != choice.pose.is_scanner)
    return;
  if (choice.pose.is_scanner && (choice.pose.origin - middle).norm() > kFarthestScanner * size) return;
  choice.residual = tables.residual(lattice, choice.pose);
  if (kAsGood * choice.residual < best.residual) best = choice;
}

/// What was found in the last cloud explains this one as well.
bool GeometryFinder::Memory::isAsBefore(const CloudOptions& options) {
  Choice now = *last, best;
  consider(now, options, best);
  if (!(best.residual <= kAsBefore * last->residual + kSlack)) return false;
  last->residual = best.residual;
  return true;
}

/// The axes of a frame in any order.
void GeometryFinder::Memory::considerAxes(const SensorPose& from, const CloudOptions& options, Choice& best) {
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

void GeometryFinder::Memory::considerSearch(const CloudOptions& options, Choice& best) {
  for (const bool at_origin : {true, false}) {
    const auto pose = at_origin ? cameraAtOrigin(lattice) : cameraAnywhere(lattice);
    Choice choice;
    if (!pose) continue;
    choice.pose = *pose;
    consider(choice, options, best);
  }
  if (options.sensor != CloudOptions::Sensor::Camera && best.residual > kClear) considerScanners(options, best);
}

void GeometryFinder::Memory::considerScanners(const CloudOptions& options, Choice& best) {
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
      if (best.residual <= kClear) return;
      refineScanner(lattice, choice.pose);
      consider(choice, options, best);
      if (best.residual <= kClear) return;
    }
  }
}

/// Across grows with the column and along with the row: the picture's right and down.
void GeometryFinder::Memory::orient(Choice& choice) const {
  if (choice.is_plain || choice.pose.is_scanner) return;
  double across = 0.0, along = 0.0;
  const double middle_column = 0.5 * static_cast<double>(lattice.columns().size() - 1);
  const double middle_row = 0.5 * static_cast<double>(lattice.rows().size() - 1);
  double mean_u = 0.0, mean_v = 0.0, n = 0.0;
  for (const bool is_second : {false, true})
    for (const PointLattice::Point& point : lattice.points()) {
      const Eigen::Vector3d s = choice.pose.inSensor(point.p);
      if (!(s.z() > 0.0)) continue;
      if (!is_second) {
        mean_u += s.x() / s.z();
        mean_v += s.y() / s.z();
        n += 1.0;
      } else {
        across += (point.column - middle_column) * (s.x() / s.z() - mean_u / n);
        along += (point.row - middle_row) * (s.y() / s.z() - mean_v / n);
      }
    }
  if (across < 0.0) choice.pose.axes.col(0) *= -1.0;
  if (along < 0.0) choice.pose.axes.col(1) *= -1.0;
}

void GeometryFinder::Memory::measureSize() {
  const auto n = static_cast<double>(lattice.points().size());
  middle.setZero();
  for (const PointLattice::Point& point : lattice.points()) middle += point.p / n;
  size = 0.0;
  for (const PointLattice::Point& point : lattice.points()) size += (point.p - middle).norm() / n;
}

double GeometryFinder::Memory::medianDistance(const PoseHypothesis& pose) {
  distances.clear();
  for (const PointLattice::Point& point : lattice.points()) distances.push_back((point.p - pose.origin).norm());
  if (distances.empty()) return 0.0;
  const auto at = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), at, distances.end());
  return *at;
}

void GeometryFinder::Memory::choose(const CloudView& cloud, const CloudOptions& options) {
  lattice.read(cloud, kFewLines, kFewLines, options.invalid, geometry.invalid_points);
  for (int lines = 2 * kFewLines;
       lattice.points().size() < kEnoughPoints && !lattice.isWhole(cloud) && lines <= kMostLines; lines *= 2)
    lattice.read(cloud, lines, lines, options.invalid, geometry.invalid_points);
  Choice best =
      plainChoice(options.sensor == CloudOptions::Sensor::Scanner ? Projection::Spherical : Projection::Perspective);
  if (options.projection) best = plainChoice(*options.projection);
  if (options.projection || !tellsGeometry()) return describe(cloud, options, best);
  measureSize();
  for (const Projection projection : {Projection::Perspective, Projection::PerspectiveBackward, Projection::Spherical})
    consider(plainChoice(projection), options, best);
  if (best.residual > kClear && last && isAsBefore(options)) {
    describe(cloud, options, *last);
    return;
  }
  if (best.residual > kClear) considerAxes(SensorPose(), options, best);
  if (best.residual > kClear && options.viewpoint) considerAxes(*options.viewpoint, options, best);
  if (best.residual > kClear) considerSearch(options, best);
  orient(best);
  last.reset();
  if (best.residual <= kMaxResidual) last = best;
  describe(cloud, options, best);
}

void GeometryFinder::Memory::describe(const CloudView& cloud, const CloudOptions& options, const Choice& best) {
  geometry.status = Status::Ok;
  geometry.problem.clear();
  geometry.residual = best.residual;
  geometry.projection = best.projection;
  if (best.pose.is_scanner) geometry.projection = Projection::Spherical;
  geometry.min_depth = options.min_depth;
  geometry.max_depth = options.max_depth;
  geometry.grid = ScanGrid();
  const bool has_points = tellsGeometry();
  if (has_points && !options.projection && !(best.residual <= kMaxResidual)) {
    geometry.status = Status::UnknownGeometry;
    geometry.problem = "no camera and no scanner sees these points in the order of the cloud's rows and columns";
    return;
  }
  const double far = best.pose.is_scanner ? kFarScanner : kFarCamera;
  geometry.unit_is_guessed = options.unit == 0.0 && has_points && medianDistance(best.pose) > far;
  geometry.unit = geometry.unit_is_guessed ? kMillimetre : options.unit > 0.0 ? options.unit : 1.0;
  geometry.pose.axes = best.pose.axes;
  geometry.pose.origin = geometry.unit * best.pose.origin;
  if (best.pose.is_scanner && has_points && !options.projection) {
    lattice.read(cloud, best.pose.rings_are_columns ? kFewLines : kManyLines,
                 best.pose.rings_are_columns ? kManyLines : kFewLines, options.invalid, other_markers);
    if (tables.residual(lattice, best.pose) <= kMaxResidual)
      geometry.grid = scanGrid(lattice, cloud, best.pose, tables);
    geometry.grid.rings_are_columns = best.pose.rings_are_columns;
  }
  if (options.invalid) geometry.invalid_points.push_back(Vector3f::Constant(*options.invalid));
  // Behind a camera nothing is measured anyway.
  const auto behind = [&](const Vector3f& p) {
    return !best.pose.is_scanner && best.pose.inSensor(p.cast<double>()).z() <= 0.0;
  };
  geometry.invalid_points.erase(std::remove_if(geometry.invalid_points.begin(), geometry.invalid_points.end(), behind),
                                geometry.invalid_points.end());
  geometry.is_plain = best.is_plain && geometry.unit == 1.0 && geometry.invalid_points.empty() &&
                      geometry.min_depth <= 0.0 && std::isinf(geometry.max_depth) && geometry.grid.ring_order.empty() &&
                      geometry.grid.ring_shift.empty();
  if (geometry.is_plain)
    geometry.pose = SensorPose();
  else if (geometry.projection == Projection::PerspectiveBackward)
    geometry.projection = Projection::Perspective;  // the pose turns it
}

GeometryFinder::GeometryFinder() : memory_(std::make_unique<Memory>()) {}
GeometryFinder::~GeometryFinder() = default;
GeometryFinder::GeometryFinder(GeometryFinder&&) noexcept = default;
GeometryFinder& GeometryFinder::operator=(GeometryFinder&&) noexcept = default;

const CloudGeometry& GeometryFinder::find(const float* xyz, std::size_t stride, int width, int height,
                                          const CloudOptions& options) {
  if (!memory_) memory_ = std::make_unique<Memory>();  // it was moved away
  CloudGeometry& geometry = memory_->geometry;
  geometry.problem = options.validate();
  geometry.status = Status::InvalidParameters;
  if (!geometry.problem.empty()) return geometry;
  geometry.status = Status::EmptyCloud;
  geometry.problem = "the cloud is empty";
  if (xyz == nullptr || stride < 3 || width <= 0 || height <= 0) return geometry;
  memory_->choose({xyz, stride, width, height}, options);
  return geometry;
}

CloudGeometry findGeometry(const float* xyz, std::size_t stride, int width, int height, const CloudOptions& options) {
  return GeometryFinder().find(xyz, stride, width, height, options);
}

}  // namespace epcc
