// SPDX-License-Identifier: BSD-3-Clause
// What a scanner or camera measured is worked out from each point.
#include "datasets/files/cloud_frame.h"

#include <cmath>
#include <filesystem>
#include <utility>

namespace epcc {

namespace {

float measured(const float* p, Projection projection) {
  if (!std::isfinite(p[0] + p[1] + p[2])) return 0.0F;
  if (projection == Projection::Spherical) return std::hypot(p[0], p[1], p[2]);
  const float z = projection == Projection::Perspective ? p[2] : -p[2];
  return z > 0.0F ? z : 0.0F;
}

}  // namespace

LabelledFrame cloudFrame(const std::string& name, OrganizedCloud&& cloud, Projection projection) {
  LabelledFrame frame;
  frame.name = name;
  frame.projection = projection;
  frame.depth = DepthImage(cloud.width, cloud.height);
  for (std::size_t i = 0; i < frame.depth.data.size(); ++i)
    frame.depth.data[i] = measured(&cloud.xyz[3 * i], projection);
  frame.scan = std::move(cloud.xyz);
  return frame;
}

LabelledFrame readCloud(const std::string& path) {
  OrganizedCloud cloud = readOrganizedPcd(path);
  const Projection projection = detectProjection(cloud.xyz.data(), 3, cloud.width, cloud.height);
  return cloudFrame(std::filesystem::path(path).stem().string(), std::move(cloud), projection);
}

}  // namespace epcc
