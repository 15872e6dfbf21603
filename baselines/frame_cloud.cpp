// SPDX-License-Identifier: BSD-3-Clause
// Copies the points of a frame into PCL's types.
#include "baselines/frame_cloud.h"

#include <cmath>
#include <limits>
#include <utility>

#include "datasets/support/quantile.h"

namespace epcc {

namespace {

bool finitePoint(const DepthFrame& frame, int row, int column, pcl::PointXYZ& point) {
  Eigen::Vector3d p;
  if (!frame.scanPoint(row, column, p)) return false;
  point.getVector3fMap() = p.cast<float>();
  return point.getVector3fMap().allFinite();
}

}  // namespace

MeasuredPoints measuredPoints(const DepthFrame& frame) {
  MeasuredPoints points{pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(), {}};
  pcl::PointXYZ point;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column)
      if (finitePoint(frame, row, column, point)) {
        points.cloud->push_back(point);
        points.pixels.push_back(frame.index(row, column));
      }
  return points;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr organizedCloud(const DepthFrame& frame) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(frame.width(), frame.height());
  cloud->is_dense = false;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) {
      pcl::PointXYZ& point = cloud->at(column, row);
      if (!finitePoint(frame, row, column, point)) point.getVector3fMap().setConstant(kNan);
    }
  return cloud;
}

double medianSpacing(const DepthFrame& frame) {
  std::vector<double> distances;
  distances.reserve(2 * static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height()));
  pcl::PointXYZ point, neighbour;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) {
      if (!finitePoint(frame, row, column, point)) continue;
      const auto add = [&](int other_row, int other_column) {
        if (other_row >= frame.height() || other_column >= frame.width()) return;
        if (!finitePoint(frame, other_row, other_column, neighbour)) return;
        const Eigen::Vector3f step = neighbour.getVector3fMap() - point.getVector3fMap();
        distances.push_back(step.cast<double>().norm());
      };
      add(row, column + 1);
      add(row + 1, column);
    }
  if (distances.empty()) return 0.0;
  const std::size_t middle = distances.size() / 2;
  return valueOfRank(std::move(distances), middle);
}

}  // namespace epcc
