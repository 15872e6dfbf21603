// SPDX-License-Identifier: BSD-3-Clause
// Lists and reads SynPEB scans.
#include "datasets/synpeb.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "datasets/input_error.h"
#include "datasets/organized_pcd.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;
constexpr float kFirstPlane = 10.0F;

}  // namespace

std::vector<std::string> listSynpebScans(const std::string& folder) {
  std::error_code code;
  fs::directory_iterator entries(folder, code);
  if (code) throw InputError(folder, "folder", code.message());
  std::vector<std::string> names;
  for (; entries != fs::directory_iterator(); entries.increment(code))
    if (entries->path().extension() == ".pcd") names.push_back(entries->path().stem().string());
  if (code) throw InputError(folder, "folder", code.message());
  std::sort(names.begin(), names.end());
  return names;
}

LabelledFrame readSynpebScan(const std::string& folder, const std::string& name) {
  const OrganizedCloud cloud = readOrganizedPcd((fs::path(folder) / (name + ".pcd")).string(), "intensity");
  LabelledFrame frame;
  frame.name = name;
  frame.camera.noise = "0.01,0,1";
  frame.depth = DepthImage(cloud.width, cloud.height);
  frame.labels = LabelImage(cloud.width, cloud.height, kIgnoreLabel);
  for (std::size_t i = 0; i < frame.depth.data.size(); ++i) {
    const float* p = &cloud.xyz[3 * i];
    if (std::isfinite(p[0])) frame.depth.data[i] = std::hypot(p[0], p[1], p[2]);
    const float label = cloud.label[i];
    if (label >= kFirstPlane && label < static_cast<float>(kIgnoreLabel))
      frame.labels.data[i] = static_cast<std::uint16_t>(label);
  }
  frame.scan = cloud.xyz;
  return frame;
}

}  // namespace epcc
