// SPDX-License-Identifier: BSD-3-Clause
// Reads a cloud's points, finds out how they were seen, and turns its label field into a label image.
#include "datasets/sources/labelled_cloud.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "datasets/files/organized_pcd.h"
#include "datasets/files/pcd_header.h"
#include "datasets/support/folder_listing.h"
#include "datasets/support/input_error.h"

namespace epcc {

namespace {

const char kLabel[] = "label";
const char kIntensity[] = "intensity";
constexpr float kFirstSynpebPlane = 10.0F;
const char kSynpebNoise[] = "0.01,0,1";

/// Name of the field that may hold labels, empty if there is none.
std::string labelField(const std::string& path) {
  const PcdHeader header = readPcdHeader(path);
  for (const char* name : {kLabel, kIntensity})
    if (header.field(name) != nullptr) return name;
  return {};
}

std::uint16_t plainLabel(float value) {
  return value >= 1.0F && value <= static_cast<float>(kIgnoreLabel) ? static_cast<std::uint16_t>(value)
                                                                    : std::uint16_t{0};
}

std::uint16_t synpebLabel(float value) {
  return value >= kFirstSynpebPlane && value < static_cast<float>(kIgnoreLabel) ? static_cast<std::uint16_t>(value)
                                                                                : kIgnoreLabel;
}

/// The first point whose value is a number but no whole one, or the number of points.
std::size_t firstFraction(const std::vector<float>& values) {
  const auto fraction = std::find_if(values.begin(), values.end(),
                                     [](float value) { return std::isfinite(value) && value != std::floor(value); });
  return static_cast<std::size_t>(fraction - values.begin());
}

std::optional<SensorPose> viewpointOf(const OrganizedCloud& cloud) {
  const auto& v = cloud.viewpoint;
  const Eigen::Quaterniond turn(v[3], v[4], v[5], v[6]);
  SensorPose pose;
  pose.origin = Eigen::Vector3d(v[0], v[1], v[2]);
  pose.axes = turn.normalized().toRotationMatrix();
  if (pose.origin.isZero() && pose.axes.isIdentity()) return std::nullopt;
  return pose;
}

/// Takes the points out of the cloud.
LabelledFrame unlabelledFrame(const std::string& path, OrganizedCloud& cloud, bool is_scan) {
  LabelledFrame frame;
  frame.name = std::filesystem::path(path).stem().string();
  frame.known.viewpoint = viewpointOf(cloud);
  if (is_scan) frame.known.projection = Projection::Spherical;
  frame.depth = DepthImage(cloud.width, cloud.height);
  frame.scan = std::move(cloud.xyz);
  findCloudGeometry(frame, frame.known);
  return frame;
}

}  // namespace

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
  return unlabelledFrame(path, cloud, false);
}

LabelledFrame readLabelledCloud(const std::string& path) {
  const std::string field = labelField(path);
  if (field.empty()) return readCloud(path);
  OrganizedCloud cloud = readOrganizedPcd(path, field);
  const bool is_intensity = field == kIntensity;
  const std::size_t fraction = firstFraction(cloud.label);
  const bool whole = fraction == cloud.label.size();
  if (!whole && !is_intensity)
    throw InputError(path, field, "of point " + std::to_string(fraction) + " is not a whole number, so it is no label");
  const bool synpeb = is_intensity && whole;
  LabelledFrame frame = unlabelledFrame(path, cloud, synpeb);
  if (!whole) return frame;
  if (synpeb) frame.camera.noise = kSynpebNoise;
  frame.labels = LabelImage(cloud.width, cloud.height);
  std::transform(cloud.label.begin(), cloud.label.end(), frame.labels.data.begin(), synpeb ? synpebLabel : plainLabel);
  return frame;
}

LabelledCloudFolder::LabelledCloudFolder(const std::string& folder)
    : NamedFrames(folder, filesEndingIn(folder, ".pcd"), "cloud NAME.pcd") {}

}  // namespace epcc
