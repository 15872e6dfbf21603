// SPDX-License-Identifier: BSD-3-Clause
// The list is versioned JSON; contours are traced from the label image.
#include "datasets/files/plane_list.h"

#include "datasets/files/vector_json.h"
#include "datasets/support/atomic_file.h"
#include "epcc_segmentation/contours.h"

namespace epcc {

namespace {

nlohmann::json contourJson(const std::vector<PixelContour>& contours) {
  nlohmann::json json{{"outer", nlohmann::json::array()}, {"holes", nlohmann::json::array()}};
  for (const auto& contour : contours) {
    auto points = nlohmann::json::array();
    for (const auto& point : contour.points) points.push_back({point.x(), point.y()});
    json[contour.is_hole ? "holes" : "outer"].push_back(std::move(points));
  }
  return json;
}

nlohmann::json planeJson(std::size_t id, const Plane& plane, const std::vector<PixelContour>& contours) {
  nlohmann::json covariance = nlohmann::json::array();
  for (int row = 0; row < 4; ++row) covariance.push_back(vectorJson(plane.coefficients_covariance.col(row)));
  return {{"id", id},
          {"coefficients", vectorJson(plane.coefficients)},
          {"coefficients_covariance", covariance},
          {"pixel_count", plane.pixel_count},
          {"rms", plane.rms},
          {"confidence", plane.confidence},
          {"centroid", vectorJson(plane.centroid)},
          {"contour", contourJson(contours)}};
}

const char* frameOf(Projection projection) {
  if (projection == Projection::PerspectiveBackward) return "camera x right, y up, z backward";
  if (projection == Projection::Spherical) return "spherical scan x forward, y left, z up";
  return "camera x right, y down, z forward";
}

/// Only the unit or the order of pixels is another.
bool isFrameOf(const CloudGeometry& geometry) {
  return geometry.pose.axes.isIdentity() && geometry.pose.origin.isZero();
}

/// Where the sensor is in a cloud of a frame of its own, as columns of its axes and its origin.
nlohmann::json sensorJson(const CloudGeometry& geometry) {
  nlohmann::json pose = nlohmann::json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.push_back(geometry.pose.axes(row, column));
    pose.push_back(geometry.pose.origin(row));
  }
  return {{"kind", isPerspective(geometry.projection) ? "camera" : "scanner"}, {"pose", pose}};
}

}  // namespace

nlohmann::json planeListJson(const PlaneSegmentation& segmentation, Projection projection,
                             const CloudGeometry* geometry) {
  const auto contours = traceAllContours(segmentation.labels, segmentation.width, segmentation.height,
                                         static_cast<std::int32_t>(segmentation.planes.size()));
  nlohmann::json planes = nlohmann::json::array();
  for (std::size_t k = 0; k < segmentation.planes.size(); ++k)
    planes.push_back(planeJson(k + 1, segmentation.planes[k], contours[k]));
  nlohmann::json list{{"version", 1},
                      {"width", segmentation.width},
                      {"height", segmentation.height},
                      {"frame", frameOf(projection)},
                      {"planes", planes}};
  if (geometry != nullptr && !isFrameOf(*geometry)) {
    list["frame"] = "cloud";
    list["sensor"] = sensorJson(*geometry);
  }
  return list;
}

void writePlaneList(const std::string& path, const PlaneSegmentation& segmentation, Projection projection,
                    const CloudGeometry* geometry) {
  writeTextFile(path, planeListJson(segmentation, projection, geometry).dump() + "\n");
}

}  // namespace epcc
