// SPDX-License-Identifier: BSD-3-Clause
// Finds out how a cloud was seen, and turns its label field into a label image.
#include "datasets/sources/labelled_cloud.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "datasets/files/cloud_frame.h"
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

bool isWhole(float value) {
  return std::isfinite(value) && value == std::floor(value);
}

bool isMeasured(const float* point) {
  return !std::isnan(point[0]) && (point[0] != 0.0F || point[1] != 0.0F || point[2] != 0.0F);
}

/// The first point whose label is no whole number, or the number of points. What is not measured may have none, NaN.
std::size_t firstFraction(const OrganizedCloud& cloud) {
  std::size_t i = 0;
  const auto is_label = [&] {
    return isWhole(cloud.label[i]) || (std::isnan(cloud.label[i]) && !isMeasured(&cloud.xyz[3 * i]));
  };
  while (i < cloud.label.size() && is_label()) ++i;
  return i;
}

}  // namespace

LabelledFrame readLabelledCloud(const std::string& path) {
  const std::string field = labelField(path);
  if (field.empty()) return readCloud(path);
  OrganizedCloud cloud = readOrganizedPcd(path, field);
  const bool is_intensity = field == kIntensity;
  const std::size_t fraction = firstFraction(cloud);
  const bool whole = fraction == cloud.label.size();
  if (!whole && !is_intensity)
    throw InputError(path, field, "of point " + std::to_string(fraction) + " is not a whole number, so it is no label");
  const bool synpeb = is_intensity && whole;
  LabelledFrame frame = cloudFrame(std::filesystem::path(path).stem().string(), cloud, synpeb);
  if (!whole) return frame;
  frame.labels = LabelImage(cloud.width, cloud.height);
  std::transform(cloud.label.begin(), cloud.label.end(), frame.labels.data.begin(), synpeb ? synpebLabel : plainLabel);
  if (synpeb) frame.camera.noise = kSynpebNoise;
  return frame;
}

LabelledCloudFolder::LabelledCloudFolder(const std::string& folder)
    : NamedFrames(folder, filesEndingIn(folder, ".pcd"), "cloud NAME.pcd") {}

}  // namespace epcc
