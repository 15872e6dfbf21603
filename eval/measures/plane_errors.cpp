// SPDX-License-Identifier: BSD-3-Clause
// Reads true planes and compares them with those found.
#include "eval/measures/plane_errors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace epcc {

namespace {

constexpr double kMicro = 1e6;
constexpr double kDegrees = 180.0 / M_PI;

std::optional<Eigen::Vector4d> normalized(const Eigen::Vector4d& plane) {
  const double length = plane.head<3>().norm();
  if (!(length > 0.0) || !plane.allFinite()) return std::nullopt;
  return Eigen::Vector4d(plane / length);
}

std::optional<Eigen::Vector4d> coefficients(const nlohmann::json& entry) {
  const auto found = entry.find("coefficients");
  if (found == entry.end() || !found->is_array() || found->size() != 4) return std::nullopt;
  Eigen::Vector4d plane;
  for (int i = 0; i < 4; ++i) {
    const nlohmann::json& value = (*found)[static_cast<std::size_t>(i)];
    if (!value.is_number()) return std::nullopt;
    plane(i) = value.get<double>();
  }
  return normalized(plane);
}

PlaneError compare(const Eigen::Vector4d& truth, const Eigen::Vector4d& found) {
  const Eigen::Vector3d normal = truth.head<3>();
  const double side = normal.dot(found.head<3>()) < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d other = side * found.head<3>();
  PlaneError error;
  error.normal_degrees = kDegrees * std::atan2(normal.cross(other).norm(), normal.dot(other));
  error.offset_metres = std::abs(truth(3) - side * found(3));
  return error;
}

/// By column, the row of the largest cluster that the surface dominates; 0: none.
std::vector<std::size_t> largestClusters(const OverlapTable& table) {
  std::vector<std::size_t> largest(table.surfaceCount() + 1, 0);
  for (std::size_t c = 1; c <= table.clusterCount(); ++c) {
    const std::size_t g = table.dominant(c);
    if (largest[g] == 0 || table.overlap(c, g) > table.overlap(largest[g], g)) largest[g] = c;
  }
  return largest;
}

double mean(long millionths, long count) {
  if (count == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(millionths) / kMicro / static_cast<double>(count);
}

}  // namespace

TruePlanes truePlanes(const nlohmann::json& camera_extra) {
  TruePlanes planes;
  const auto list = camera_extra.find("planes");
  if (list == camera_extra.end() || !list->is_array()) return planes;
  for (const nlohmann::json& entry : *list) {
    if (!entry.is_object()) continue;
    const auto id = entry.find("id");
    if (id == entry.end() || !id->is_number_integer() || *id < 1 || *id >= kIgnoreLabel) continue;
    const std::optional<Eigen::Vector4d> plane = coefficients(entry);
    if (plane) planes[id->get<std::int32_t>()] = *plane;
  }
  return planes;
}

std::vector<PlaneError> planeErrors(const OverlapTable& table, const TruePlanes& truth,
                                    const std::vector<Plane>& planes) {
  std::vector<PlaneError> errors;
  const std::vector<std::size_t> largest = largestClusters(table);
  for (std::size_t g = 1; g <= table.surfaceCount(); ++g) {
    const auto true_plane = truth.find(table.surfaceIds()[g]);
    const std::int32_t cluster_id = table.clusterIds()[largest[g]];
    if (true_plane == truth.end() || cluster_id == 0 || static_cast<std::size_t>(cluster_id) > planes.size()) continue;
    const auto found = normalized(planes[static_cast<std::size_t>(cluster_id) - 1].coefficients);
    if (!found) continue;
    PlaneError error = compare(true_plane->second, *found);
    error.surface_id = true_plane->first;
    error.cluster_id = cluster_id;
    errors.push_back(error);
  }
  return errors;
}

double PlaneErrorSums::meanNormalDegrees() const {
  return mean(microdegrees, planes);
}

double PlaneErrorSums::meanOffsetMetres() const {
  return mean(micrometres, planes);
}

PlaneErrorSums& PlaneErrorSums::operator+=(const PlaneErrorSums& other) {
  planes += other.planes;
  microdegrees += other.microdegrees;
  micrometres += other.micrometres;
  return *this;
}

PlaneErrorSums sumPlaneErrors(const std::vector<PlaneError>& errors) {
  PlaneErrorSums sums;
  for (const PlaneError& error : errors) {
    ++sums.planes;
    sums.microdegrees += std::lround(kMicro * error.normal_degrees);
    sums.micrometres += std::lround(kMicro * error.offset_metres);
  }
  return sums;
}

}  // namespace epcc
