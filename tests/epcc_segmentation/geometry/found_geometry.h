// SPDX-License-Identifier: BSD-3-Clause
// Segments clouds whose geometry is found, and compares the result with the truth.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "epcc_segmentation/cloud_geometry.h"
#include "epcc_segmentation/plane_extractor.h"
#include "tests/support/posed_clouds.h"

namespace epcc::test {

inline const Eigen::Matrix3d kNoTurn = Eigen::Matrix3d::Identity();
inline const Eigen::Vector3d kOrigin = Eigen::Vector3d::Zero();
inline const Eigen::Vector3d kShift(0.9, -0.5, 0.62);  // 1.2 m
inline const Eigen::Matrix3d kTurn =
    Eigen::AngleAxisd(25.0 * M_PI / 180.0, Eigen::Vector3d(0.3, 1.0, -0.2).normalized()).toRotationMatrix();

inline Eigen::Matrix3d bodyAxes() {  // x forward, y left, z up
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return axes;
}

inline CloudGeometry geometryOf(const PosedCloud& cloud, const CloudOptions& options = CloudOptions()) {
  return findGeometry(cloud.xyz.data(), 3, cloud.width, cloud.height, options);
}

struct Found {
  CloudGeometry geometry;
  PlaneSegmentation result;
  std::string error;
};

inline Found segment(const PosedCloud& cloud, const CloudOptions& options = CloudOptions()) {
  Found found;
  found.geometry = geometryOf(cloud, options);
  const bool is_scan = found.geometry.projection == Projection::Spherical;
  PlaneExtractor extractor(Parameters(), SensorModel::parse(is_scan ? "0.03,0,1" : "0.008,0.001,1"));
  const auto frame = DepthFrame::fromPoints(cloud.xyz.data(), 3, cloud.width, cloud.height, found.geometry);
  extractor.extract(frame, found.result);
  found.error = extractor.error();
  return found;
}

/// Each plane of the truth is one label on nearly all of its pixels.
inline void expectTruth(const PosedCloud& cloud, const PlaneSegmentation& result, int planes) {
  ASSERT_EQ(result.width, cloud.width);
  ASSERT_EQ(result.height, cloud.height);
  ASSERT_EQ(result.labels.size(), cloud.size());
  EXPECT_EQ(result.planes.size(), static_cast<std::size_t>(planes));
  std::map<std::int32_t, std::map<std::int32_t, int>> votes;
  std::map<std::int32_t, int> count;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.truth[i] == 0) continue;
    ++votes[cloud.truth[i]][result.labels[i]];
    ++count[cloud.truth[i]];
  }
  std::map<std::int32_t, int> used;
  for (const auto& [plane, labels] : votes) {
    const auto best = std::max_element(labels.begin(), labels.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    EXPECT_NE(best->first, 0) << "plane " << plane;
    EXPECT_GE(best->second, 0.95 * count[plane]) << "plane " << plane;
    EXPECT_EQ(++used[best->first], 1) << "plane " << plane;
  }
}

/// The planes go through their points, in metres and in the cloud's frame, and face the sensor.
inline void expectPlanesOnTheirPoints(const PosedCloud& cloud, const Found& found, double unit,
                                      const Eigen::Vector3d& sensor) {
  ASSERT_EQ(found.result.labels.size(), cloud.size());
  std::vector<double> squares(found.result.planes.size(), 0.0), counts(squares);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::int32_t label = found.result.labels[i];
    if (label == 0) continue;
    const Eigen::Vector3d p = unit * Eigen::Map<const Eigen::Vector3f>(&cloud.xyz[3 * i]).cast<double>();
    const double distance = found.result.planes[static_cast<std::size_t>(label - 1)].signedDistance(p);
    squares[static_cast<std::size_t>(label - 1)] += distance * distance;
    counts[static_cast<std::size_t>(label - 1)] += 1.0;
  }
  for (std::size_t k = 0; k < squares.size(); ++k) {
    const Plane& plane = found.result.planes[k];
    EXPECT_LT(std::sqrt(squares[k] / counts[k]), 0.02) << k;
    EXPECT_GT(plane.signedDistance(sensor), 0.0) << k;
    EXPECT_NEAR(plane.signedDistance(plane.centroid), 0.0, 0.01) << k;
    EXPECT_LT(plane.rms, 0.02) << k;
    EXPECT_NEAR(plane.coefficients.head<3>().norm(), 1.0, 1e-9) << k;
  }
}

inline PosedCloud posedRoom() {
  return cameraCloud(renderRoom(cornerPlanes(), testCamera()));
}

}  // namespace epcc::test
