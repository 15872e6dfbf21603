// SPDX-License-Identifier: BSD-3-Clause
// Turns a cloud's label field into a label image.
#include "datasets/sources/labelled_cloud.h"

#include <cmath>
#include <filesystem>

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

std::string labelField(const std::string& path) {
  const PcdHeader header = readPcdHeader(path);
  for (const char* name : {kLabel, kIntensity})
    if (header.field(name) != nullptr) return name;
  throw InputError(path, "FIELDS", "neither label nor intensity is there to hold labels");
}

std::uint16_t plainLabel(float value) {
  return value >= 1.0F && value <= static_cast<float>(kIgnoreLabel) ? static_cast<std::uint16_t>(value)
                                                                    : std::uint16_t{0};
}

std::uint16_t synpebLabel(float value) {
  return value >= kFirstSynpebPlane && value < static_cast<float>(kIgnoreLabel) ? static_cast<std::uint16_t>(value)
                                                                                : kIgnoreLabel;
}

/// An intensity that was measured is no label.
void checkWhole(const std::string& path, const std::string& field, const std::vector<float>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i]) && values[i] != std::floor(values[i]))
      throw InputError(path, field, "of point " + std::to_string(i) + " is not a whole number, so it is no label");
}

float measured(const float* p, Projection projection) {
  if (!std::isfinite(p[0] + p[1] + p[2])) return 0.0F;
  if (projection == Projection::Spherical) return std::hypot(p[0], p[1], p[2]);
  const float z = projection == Projection::Perspective ? p[2] : -p[2];
  return z > 0.0F ? z : 0.0F;
}

}  // namespace

LabelledFrame readLabelledCloud(const std::string& folder, const std::string& name) {
  const std::string path = (std::filesystem::path(folder) / (name + ".pcd")).string();
  const std::string field = labelField(path);
  const bool synpeb = field == kIntensity;
  OrganizedCloud cloud = readOrganizedPcd(path, field);
  checkWhole(path, field, cloud.label);
  LabelledFrame frame;
  frame.name = name;
  if (synpeb) frame.camera.noise = kSynpebNoise;
  frame.projection = synpeb ? Projection::Spherical : detectProjection(cloud.xyz.data(), 3, cloud.width, cloud.height);
  frame.depth = DepthImage(cloud.width, cloud.height);
  frame.labels = LabelImage(cloud.width, cloud.height);
  for (std::size_t i = 0; i < frame.depth.data.size(); ++i) {
    frame.depth.data[i] = measured(&cloud.xyz[3 * i], frame.projection);
    frame.labels.data[i] = synpeb ? synpebLabel(cloud.label[i]) : plainLabel(cloud.label[i]);
  }
  frame.scan = std::move(cloud.xyz);
  return frame;
}

LabelledCloudFolder::LabelledCloudFolder(const std::string& folder)
    : NamedFrames(folder, filesEndingIn(folder, ".pcd"), "cloud NAME.pcd") {}

}  // namespace epcc
