// SPDX-License-Identifier: BSD-3-Clause
// Geometries of streams and what can be wrong with them.
#include "epcc_segmentation/stream_geometry.h"

#include <algorithm>
#include <cmath>

#include "pi.h"

namespace epcc {

namespace {

constexpr int kMaxSamples = 65536;
constexpr double kSmallestStep = 1e-6;           // radians
constexpr double kLargestRingAzimuth = kPi / 4;  // degrees taken for radians are beyond it
constexpr int kMostColumnsApart = 4096;          // of the rings of a scan line: so many columns are kept

std::string elevationsProblem(const std::vector<double>& elevations) {
  for (const double elevation : elevations)
    if (!(std::abs(elevation) < kPi / 2)) return "elevations must lie between -pi/2 and pi/2 radians";
  for (std::size_t i = 2; i < elevations.size(); ++i)
    if ((elevations[i] - elevations[i - 1]) * (elevations[1] - elevations[0]) <= 0.0)
      return "elevations must rise from ring to ring, or fall: sort the rings";
  if (elevations.size() == 2 && elevations[0] == elevations[1]) return "elevations must differ from ring to ring";
  return {};
}

/// Of offsets that a valid step belongs to.
std::string ringAzimuthsProblem(const StreamGeometry& geometry) {
  const std::vector<double>& azimuths = geometry.ringAzimuths();
  if (azimuths.empty()) return {};
  if (azimuths.size() != geometry.elevations().size())
    return "there must be a ring azimuth for each of the " + std::to_string(geometry.elevations().size()) +
           " elevations, not " + std::to_string(azimuths.size());
  int least = geometry.ringShift(0), most = least;
  for (std::size_t ring = 0; ring < azimuths.size(); ++ring) {
    if (!(std::abs(azimuths[ring]) <= kLargestRingAzimuth))
      return "ring azimuths must lie within pi/4 radians of the column's";
    least = std::min(least, geometry.ringShift(static_cast<int>(ring)));
    most = std::max(most, geometry.ringShift(static_cast<int>(ring)));
  }
  if (most - least > kMostColumnsApart)
    return "ring azimuths must be at most " + std::to_string(kMostColumnsApart) + " columns apart, not " +
           std::to_string(most - least);
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

StreamGeometry StreamGeometry::scanner(const std::vector<double>& elevations, double azimuth_step,
                                       const std::vector<double>& ring_azimuths) {
  StreamGeometry geometry;
  geometry.kind_ = Kind::Scanner;
  geometry.elevations_ = elevations;
  geometry.ring_azimuths_ = ring_azimuths;
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

bool StreamGeometry::isStaggered() const {
  return std::any_of(ring_azimuths_.begin(), ring_azimuths_.end(), [](double azimuth) { return azimuth != 0.0; });
}

int StreamGeometry::ringShift(int ring) const {
  const auto at = static_cast<std::size_t>(ring);
  if (at >= ring_azimuths_.size() || !(std::abs(azimuth_step_) >= kSmallestStep)) return 0;
  const double azimuth = ring_azimuths_[at];
  return std::abs(azimuth) <= kLargestRingAzimuth ? static_cast<int>(std::lround(-azimuth / azimuth_step_)) : 0;
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
  return ringAzimuthsProblem(*this);
}

}  // namespace epcc
