// SPDX-License-Identifier: BSD-3-Clause
// Chooses between hypotheses: simple ones first, and a search only where none of them explains the points.
#include "epcc_segmentation/cloud_geometry.h"

#include <Eigen/Core>
#include <cmath>
#include <new>

#include "depth_range.h"
#include "geometry/hypothesis_search.h"
#include "geometry/scan_grid.h"
#include "quantile.h"

namespace epcc {

namespace {

// Scanners, whose rings may each be ahead of the others, are looked at ring by ring.
constexpr int kManyLines = 128;
constexpr int kMostLines = 256;  // where points are few
constexpr std::size_t kEnoughPoints = 200;
constexpr double kAsBefore = 1.3;  // residual of the pose of the last cloud
constexpr double kSlack = 3e-4;

// No camera's picture lies farther away than this in the middle, metres, and no scanner's: then the unit is the
// millimetre.
constexpr double kFarCamera = 100.0;
constexpr double kFarScanner = 1000.0;
constexpr double kMillimetre = 0.001;

}  // namespace

std::string CloudOptions::validate() const {
  if (!std::isfinite(unit) || unit < 0.0) return "the unit must be positive, in metres, or 0 where it is not known";
  if (!isDepthRange(min_depth, max_depth)) return kNoDepthRange;
  if (viewpoint && !(viewpoint->axes.allFinite() && viewpoint->origin.allFinite()))
    return "the viewpoint is not finite";
  return {};
}

struct GeometryFinder::Memory : HypothesisSearch {
  std::vector<double> distances;
  std::optional<Choice> last;
  CloudGeometry geometry;

  void choose(const CloudView& cloud, const CloudOptions& options);

 private:
  bool isAsBefore(const CloudOptions& options);
  void orient(Choice& choice) const;
  void describe(const CloudView& cloud, const CloudOptions& options, const Choice& best);
  double medianDistance(const PoseHypothesis& pose);
};

/// What was found in the last cloud explains this one as well.
bool GeometryFinder::Memory::isAsBefore(const CloudOptions& options) {
  Choice now = *last, best;
  consider(now, options, best);
  if (!(best.residual <= kAsBefore * last->residual + kSlack)) return false;
  last->residual = best.residual;
  return true;
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

double GeometryFinder::Memory::medianDistance(const PoseHypothesis& pose) {
  distances.clear();
  for (const PointLattice::Point& point : lattice.points()) distances.push_back((point.p - pose.origin).norm());
  return distances.empty() ? 0.0 : median(distances);
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
  if (best.residual > kClearResidual && last && isAsBefore(options)) {
    describe(cloud, options, *last);
    return;
  }
  if (best.residual > kClearResidual) considerAxes(SensorPose(), options, best);
  if (best.residual > kClearResidual && options.viewpoint) considerAxes(*options.viewpoint, options, best);
  if (best.residual > kClearResidual) considerSearch(options, best);
  if (best.residual <= kMaxResidual && best.pose.is_scanner && repeatsRings(cloud, options, best.pose))
    best.residual = kNoRays;
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
    geometry.problem = "no camera and no scanner sees these points in the order of the cloud's rows and columns" +
                       wrongSize(cloud, options);
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

namespace {

void setOutOfMemory(CloudGeometry& geometry) {
  geometry.status = Status::OutOfMemory;
  geometry.problem = "out of memory";  // short enough to need none
}

}  // namespace

const CloudGeometry& GeometryFinder::find(const float* xyz, std::size_t stride, int width, int height,
                                          const CloudOptions& options) try {
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
} catch (const std::bad_alloc&) {
  if (!memory_) throw;  // there is no place for a geometry
  memory_->last.reset();
  setOutOfMemory(memory_->geometry);
  return memory_->geometry;
}

CloudGeometry findGeometry(const float* xyz, std::size_t stride, int width, int height,
                           const CloudOptions& options) try {
  return GeometryFinder().find(xyz, stride, width, height, options);
} catch (const std::bad_alloc&) {
  CloudGeometry geometry;
  setOutOfMemory(geometry);
  return geometry;
}

}  // namespace epcc
