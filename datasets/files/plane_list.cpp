// SPDX-License-Identifier: BSD-3-Clause
// The list is versioned JSON; contours are traced from the label image.
#include "datasets/files/plane_list.h"

#include "datasets/support/atomic_file.h"
#include "epcc_segmentation/contours.h"

namespace epcc {

namespace {

nlohmann::json vectorJson(const Eigen::Ref<const Eigen::VectorXd>& vector) {
  return std::vector<double>(vector.data(), vector.data() + vector.size());
}

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
          {"centroid", vectorJson(plane.centroid)},
          {"contour", contourJson(contours)}};
}

}  // namespace

nlohmann::json planeListJson(const PlaneSegmentation& segmentation, Projection projection) {
  const auto contours = traceAllContours(segmentation.labels, segmentation.width, segmentation.height,
                                         static_cast<std::int32_t>(segmentation.planes.size()));
  nlohmann::json planes = nlohmann::json::array();
  for (std::size_t k = 0; k < segmentation.planes.size(); ++k)
    planes.push_back(planeJson(k + 1, segmentation.planes[k], contours[k]));
  const char* frame = "camera x right, y down, z forward";
  if (projection == Projection::PerspectiveBackward) frame = "camera x right, y up, z backward";
  if (projection == Projection::Spherical) frame = "spherical scan x forward, y left, z up";
  return {{"version", 1},
          {"width", segmentation.width},
          {"height", segmentation.height},
          {"frame", frame},
          {"planes", planes}};
}

void writePlaneList(const std::string& path, const PlaneSegmentation& segmentation, Projection projection) {
  writeTextFile(path, planeListJson(segmentation, projection).dump() + "\n");
}

}  // namespace epcc
