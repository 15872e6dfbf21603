// SPDX-License-Identifier: BSD-3-Clause
// Reads the lists of depth images; knows the published cameras.
#include "datasets/sources/tum_folder.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unordered_set>
#include <utility>

#include "datasets/sources/depth_image_folder.h"
#include "datasets/support/folder_listing.h"
#include "datasets/support/input_error.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;

constexpr double kUnitsPerMetre = 5000.0;
constexpr std::uintmax_t kMaxListBytes = 256u << 20;

struct SensorCamera {
  PinholeCamera camera;
  const char* noise;
};
// TUM's depth is registered to the colour camera, whose calibration therefore holds; the correction of the depth scale
// is in the files already. ICL-NUIM publishes fy = -480: its y axis points up.
const SensorCamera kFreiburg1 = {{640, 480, 517.3, 516.5, 318.6, 255.3}, "kinect-v1"};
const SensorCamera kFreiburg2 = {{640, 480, 520.9, 521.0, 325.1, 249.7}, "kinect-v1"};
const SensorCamera kFreiburg3 = {{640, 480, 535.4, 539.2, 320.1, 247.6}, "kinect-v1"};
const SensorCamera kIcl = {{640, 480, 481.2, 480.0, 319.5, 239.5}, "rendered"};

bool isDepthEntry(const std::string& word) {
  return word.rfind("depth/", 0) == 0 && hasEnding(word, ".png") && word.find("..") == std::string::npos;
}

/// The depth images that a list names, in its order: one word of each line is depth/SOMETHING.png.
std::vector<std::string> listedDepthFiles(const std::string& path) {
  const std::uintmax_t size = inputFileSize(path);
  if (size > kMaxListBytes) throw InputError(path, "file", "is larger than 256 MiB");
  std::ifstream in(path);
  std::vector<std::string> files;
  std::unordered_set<std::string> seen;
  std::string line;
  for (long number = 1; std::getline(in, line); ++number) {
    std::istringstream words(line);
    std::vector<std::string> all;
    for (std::string word; words >> word;) all.push_back(word);
    if (all.empty() || all.front().front() == '#') continue;
    const auto depth = std::find_if(all.begin(), all.end(), isDepthEntry);
    if (depth == all.end())
      throw InputError(path, "line " + std::to_string(number), "names no file depth/SOMETHING.png");
    if (seen.insert(*depth).second) files.push_back(*depth);
  }
  requireNotCutOff(path, size);
  if (files.empty()) throw InputError(path, "file", "names no depth image");
  return files;
}

/// By associations.txt, else depth.txt, else all that lies in depth/.
std::vector<std::string> depthFiles(const std::string& folder) {
  for (const char* list : {"associations.txt", "depth.txt"}) {
    const std::string path = (fs::path(folder) / list).string();
    std::error_code code;
    if (fs::exists(path, code)) return listedDepthFiles(path);
  }
  return depthImagesIn(folder, "depth");
}

std::unique_ptr<FrameSource> openWith(const std::string& folder, const SensorCamera& sensor) {
  DepthImages images;
  images.folder = folder;
  images.depth_files = depthFiles(folder);
  images.camera.camera = sensor.camera;
  images.camera.depth_scale = 1.0 / kUnitsPerMetre;
  images.camera.noise = sensor.noise;
  return std::make_unique<DepthImageFolder>(std::move(images), firstFolder(folder, {"labels"}));
}

}  // namespace

bool isTumFolder(const std::string& folder) {
  std::error_code code;
  const fs::path path(folder);
  if (!fs::is_directory(path / "depth", code)) return false;
  return fs::exists(path / "associations.txt", code) || fs::exists(path / "depth.txt", code) ||
         fs::is_directory(path / "rgb", code);
}

std::unique_ptr<FrameSource> openTumFolder(const std::string& folder) {
  std::string name = folderName(folder);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::pair<const char*, const SensorCamera*> hints[] = {{"freiburg1", &kFreiburg1},
                                                               {"freiburg2", &kFreiburg2},
                                                               {"freiburg3", &kFreiburg3},
                                                               {"fr1", &kFreiburg1},
                                                               {"fr2", &kFreiburg2},
                                                               {"fr3", &kFreiburg3},
                                                               {"icl", &kIcl},
                                                               {"living_room", &kIcl},
                                                               {"office_room", &kIcl}};
  for (const auto& [hint, sensor] : hints)
    if (name.find(hint) != std::string::npos) return openWith(folder, *sensor);
  throw InputError(folder, "name", "does not tell the camera; write tum-fr1:, tum-fr2:, tum-fr3: or icl: before it");
}

std::unique_ptr<FrameSource> openTumFreiburg1(const std::string& folder) {
  return openWith(folder, kFreiburg1);
}
std::unique_ptr<FrameSource> openTumFreiburg2(const std::string& folder) {
  return openWith(folder, kFreiburg2);
}
std::unique_ptr<FrameSource> openTumFreiburg3(const std::string& folder) {
  return openWith(folder, kFreiburg3);
}
std::unique_ptr<FrameSource> openIclFolder(const std::string& folder) {
  return openWith(folder, kIcl);
}

}  // namespace epcc
