// SPDX-License-Identifier: BSD-3-Clause
// What a scanner or camera measured is worked out from each point.
#include "datasets/files/cloud_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

namespace epcc {

namespace {

std::optional<SensorPose> viewpointOf(const OrganizedCloud& cloud) {
  const auto& v = cloud.viewpoint;
  const Eigen::Quaterniond turn(v[3], v[4], v[5], v[6]);
  SensorPose pose;
  pose.origin = Eigen::Vector3d(v[0], v[1], v[2]);
  pose.axes = turn.normalized().toRotationMatrix();
  if (pose.origin.isZero() && pose.axes.isIdentity()) return std::nullopt;
  return pose;
}

}  // namespace

LabelledFrame cloudFrame(const std::string& name, OrganizedCloud& cloud, bool is_scan) {
  LabelledFrame frame;
  frame.name = name;
  frame.known.viewpoint = viewpointOf(cloud);
  if (is_scan) frame.known.projection = Projection::Spherical;
  frame.depth = DepthImage(cloud.width, cloud.height);
  frame.scan = std::move(cloud.xyz);
  findCloudGeometry(frame, frame.known);
  return frame;
}

void findCloudGeometry(LabelledFrame& frame, const CloudOptions& options) {
  DepthImage& depth = frame.depth;
  frame.geometry = findGeometry(frame.scan.data(), 3, depth.width, depth.height, options);
  std::fill(depth.data.begin(), depth.data.end(), 0.0F);
  const DepthFrame view = frameView(frame);
  if (view.empty()) return;
  Eigen::Vector3d point;
  for (int row = 0; row < depth.height; ++row)
    for (int column = 0; column < depth.width; ++column)
      if (view.scanPoint(row, column, point))
        depth.data[view.index(row, column)] = static_cast<float>(view.measuredDepth(point));
}

LabelledFrame readCloud(const std::string& path) {
  OrganizedCloud cloud = readOrganizedPcd(path);
  return cloudFrame(std::filesystem::path(path).stem().string(), cloud, false);
}

}  // namespace epcc
