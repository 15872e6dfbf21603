// SPDX-License-Identifier: BSD-3-Clause
// Reads a cloud's points, finds out how they were seen, and turns its label field into a label image.
#include "datasets/sources/labelled_cloud.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
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

float measured(const float* p, Projection projection) {
  if (!std::isfinite(p[0] + p[1] + p[2])) return 0.0F;
  if (projection == Projection::Spherical) return std::hypot(p[0], p[1], p[2]);
  const float z = projection == Projection::Perspective ? p[2] : -p[2];
  return z > 0.0F ? z : 0.0F;
}

/// Takes the points out of the cloud.
LabelledFrame unlabelledFrame(const std::string& path, OrganizedCloud& cloud, Projection projection) {
  LabelledFrame frame;
  frame.name = std::filesystem::path(path).stem().string();
  frame.projection = projection;
  frame.depth = DepthImage(cloud.width, cloud.height);
  for (std::size_t i = 0; i < frame.depth.data.size(); ++i)
    frame.depth.data[i] = measured(&cloud.xyz[3 * i], projection);
  frame.scan = std::move(cloud.xyz);
  return frame;
}

}  // namespace

LabelledFrame readCloud(const std::string& path) {
  OrganizedCloud cloud = readOrganizedPcd(path);
  const Projection projection = detectProjection(cloud.xyz.data(), 3, cloud.width, cloud.height);
  return unlabelledFrame(path, cloud, projection);
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
  const Projection projection =
      synpeb ? Projection::Spherical : detectProjection(cloud.xyz.data(), 3, cloud.width, cloud.height);
  LabelledFrame frame = unlabelledFrame(path, cloud, projection);
  if (!whole) return frame;
  if (synpeb) frame.camera.noise = kSynpebNoise;
  frame.labels = LabelImage(cloud.width, cloud.height);
  std::transform(cloud.label.begin(), cloud.label.end(), frame.labels.data.begin(), synpeb ? synpebLabel : plainLabel);
  return frame;
}

LabelledCloudFolder::LabelledCloudFolder(const std::string& folder)
    : NamedFrames(folder, filesEndingIn(folder, ".pcd"), "cloud NAME.pcd") {}

}  // namespace epcc
