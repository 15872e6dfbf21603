// SPDX-License-Identifier: BSD-3-Clause
// Geometries of streams and what can be wrong with them.
#include "epcc_segmentation/stream_geometry.h"

#include <cmath>

#include "pi.h"

namespace epcc {

namespace {

constexpr int kMaxSamples = 65536;
constexpr double kSmallestStep = 1e-6;  // radians

std::string elevationsProblem(const std::vector<double>& elevations) {
  for (const double elevation : elevations)
    if (!(std::abs(elevation) < kPi / 2)) return "elevations must lie between -pi/2 and pi/2 radians";
  for (std::size_t i = 2; i < elevations.size(); ++i)
    if ((elevations[i] - elevations[i - 1]) * (elevations[1] - elevations[0]) <= 0.0)
      return "elevations must rise from ring to ring, or fall: sort the rings";
  if (elevations.size() == 2 && elevations[0] == elevations[1]) return "elevations must differ from ring to ring";
  return {};
}

}  // namespace

StreamGeometry StreamGeometry::cameraColumns(const PinholeCamera& camera) {
  StreamGeometry geometry;
  geometry.kind_ = Kind::CameraColumns;
  geometry.camera_ = camera;
  geometry.height_ = camera.height;
  return geometry;
}

StreamGeometry StreamGeometry::cameraRows(const PinholeCamera& camera) {
  StreamGeometry geometry;
  geometry.kind_ = Kind::CameraRows;
  geometry.camera_ = camera;
  geometry.height_ = camera.width;
  return geometry;
}

StreamGeometry StreamGeometry::scanner(const std::vector<double>& elevations, double azimuth_step) {
  StreamGeometry geometry;
  geometry.kind_ = Kind::Scanner;
  geometry.elevations_ = elevations;
  geometry.height_ = elevations.size() <= kMaxSamples ? static_cast<int>(elevations.size()) : kMaxSamples + 1;
  geometry.azimuth_step_ = azimuth_step;
  geometry.projection_ = Projection::Spherical;
  return geometry;
}

StreamGeometry StreamGeometry::points(int height, Projection projection, double azimuth_step) {
  StreamGeometry geometry;
  geometry.kind_ = Kind::Points;
  geometry.height_ = height;
  geometry.azimuth_step_ = azimuth_step;
  geometry.projection_ = projection;
  return geometry;
}

int StreamGeometry::lineCount() const {
  if (kind_ == Kind::CameraColumns) return camera_.width;
  return kind_ == Kind::CameraRows ? camera_.height : 0;
}

int StreamGeometry::columnsOfTurn() const {
  return std::abs(azimuth_step_) >= kSmallestStep ? static_cast<int>(std::lround(2.0 * kPi / std::abs(azimuth_step_)))
                                                  : 0;
}

std::string StreamGeometry::validate() const {
  if (height_ < 1 || height_ > kMaxSamples)
    return "a scan line must have 1 to " + std::to_string(kMaxSamples) + " samples, not " +
           (height_ > kMaxSamples ? "more" : std::to_string(height_));
  if (kind_ == Kind::CameraColumns || kind_ == Kind::CameraRows) {
    PinholeCamera known = camera_;
    int& lines = kind_ == Kind::CameraColumns ? known.width : known.height;
    if (lines == 0) lines = 1;
    return known.validate();
  }
  const std::string problem = elevationsProblem(elevations_);
  if (!problem.empty()) return problem;
  const double step = std::abs(azimuth_step_);
  const bool may_be_none = kind_ == Kind::Points && azimuth_step_ == 0.0;
  if (!may_be_none && !(step >= kSmallestStep && step < kPi / 2))
    return "the azimuth step must be between 1e-6 and pi/2 radians, to either side";
  return {};
}

}  // namespace epcc
