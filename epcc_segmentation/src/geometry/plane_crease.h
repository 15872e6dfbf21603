// SPDX-License-Identifier: BSD-3-Clause
// Where two planes meet, as seen in the image.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "epcc_segmentation/plane_edges.h"
#include "epcc_segmentation/sensor_model.h"
#include "geometry/pixel_rays.h"

namespace epcc {

/// The line of two planes q, seen from the sensor: the places of the image whose ray has one w on both.
class PlaneCrease {
 public:
  /// The planes' normals must differ by more than options.min_angle: exists().
  PlaneCrease(const PixelRays& rays, const SensorModel& sensor, const EdgeOptions& options, const Eigen::Vector3d& q,
              const Eigen::Vector3d& other_q);

  bool exists() const { return exists_; }
  /// Between the normals, radians.
  double angle() const { return angle_; }
  /// Signed distance of a place from the line, pixels: positive where q is nearer to the sensor than the other plane.
  double offset(double column, double row) const;
  /// The step between the planes at this place is within the noise, and the line within a few pixels.
  bool isNear(double column, double row) const;
  /// The point of the line that is nearest to the place on the picture.
  Eigen::Vector3d nearestPoint(double column, double row) const;
  /// A coordinate along the line, metres.
  double along(const Eigen::Vector3d& point) const { return direction_.dot(point); }
  const Eigen::Vector3d& direction() const { return direction_; }

 private:
  Eigen::Vector2d gradient(double column, double row) const;

  const PixelRays* rays_;
  const SensorModel* sensor_;
  const EdgeOptions* options_;
  Eigen::Vector3d q_, difference_, mean_;
  Eigen::Vector3d direction_, foot_;  // of the line
  double angle_ = 0.0;
  bool exists_ = false;
};

/// The creases of all pairs of planes, made when they are asked for.
class PlaneCreases {
 public:
  /// Planes that have none are nothing. All must outlive it.
  PlaneCreases(const PixelRays& rays, const SensorModel& sensor, const EdgeOptions& options,
               const std::vector<std::optional<Eigen::Vector3d>>& planes)
      : rays_(rays), sensor_(sensor), options_(options), planes_(planes) {}
  /// Of two labels, the first the lower one; null if the planes do not meet.
  const PlaneCrease* find(int first, int second);

 private:
  const PixelRays& rays_;
  const SensorModel& sensor_;
  const EdgeOptions& options_;
  const std::vector<std::optional<Eigen::Vector3d>>& planes_;
  std::map<std::pair<int, int>, PlaneCrease> creases_;
};

/// Gives the pixels of narrow gaps between two regions that meet there to the one or the other, up to the line.
void bridgeGaps(const PixelRays& rays, const SensorModel& sensor, const EdgeOptions& options,
                const std::vector<std::optional<Eigen::Vector3d>>& planes, PlaneCreases& creases,
                std::vector<std::int32_t>& labels);

}  // namespace epcc
