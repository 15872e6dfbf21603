// SPDX-License-Identifier: BSD-3-Clause
// Finds out what each INPUT is and reads depth images and clouds.
#include "eval/segment/segment_input.h"

#include <cmath>
#include <filesystem>

#include "datasets/files/camera_json.h"
#include "datasets/files/labelled_frame.h"
#include "datasets/files/organized_pcd.h"
#include "datasets/files/png_io.h"
#include "datasets/support/input_error.h"

namespace epcc {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDepthSuffix = "_depth";

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string frameName(const fs::path& path) {
  std::string stem = path.stem().string();
  const std::string suffix = kDepthSuffix;
  if (path.extension() == ".png" && endsWith(stem, suffix) && stem.size() > suffix.size()) {
    stem.resize(stem.size() - suffix.size());
  }
  return stem;
}

// Camera beside X_depth.png or X.png.
std::string cameraBeside(const fs::path& path) {
  return (path.parent_path() / (frameName(path) + ".json")).string();
}

void refuse(SegmentInput& input, const std::string& field, const std::string& what) {
  input.problem_field = field;
  input.problem = what;
}

SegmentInput describe(const std::string& path, const SegmentOptions& options) {
  SegmentInput input;
  input.path = path;
  input.name = frameName(path);
  std::error_code ignored;
  if (path == "-") {
    refuse(input, "standard input", "cannot be read, name a file");
  } else if (!fs::exists(path, ignored)) {
    refuse(input, "file", "does not exist");
  } else if (fs::path(path).extension() == ".pcd") {
    input.is_cloud = true;
  } else if (fs::path(path).extension() != ".png") {
    refuse(input, "name", "is neither .pcd, .png nor a folder");
  } else if (!options.camera) {
    input.camera_file = options.camera_file.empty() ? cameraBeside(path) : options.camera_file;
  }
  return input;
}

bool lacksCamera(const SegmentInput& input) {
  std::error_code ignored;
  return input.problem.empty() && !input.camera_file.empty() && !fs::exists(input.camera_file, ignored);
}

// The frames of a folder; a folder without any is one input that cannot be used.
std::vector<SegmentInput> describeFolder(const std::string& folder, const SegmentOptions& options) {
  std::vector<SegmentInput> inputs;
  try {
    for (const std::string& name : listLabelledFrames(folder)) {
      inputs.push_back(describe((fs::path(folder) / (name + kDepthSuffix + ".png")).string(), options));
    }
    if (!inputs.empty()) return inputs;
  } catch (const InputError&) {
    // Reported below in the same words.
  }
  SegmentInput none;
  none.path = folder;
  refuse(none, "folder", "has no frame NAME_depth.png that can be read");
  return {none};
}

std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

DepthImage depthOfCloud(const OrganizedCloud& cloud, Projection projection) {
  DepthImage depth;
  depth.width = cloud.width;
  depth.height = cloud.height;
  for (std::size_t i = 0; i + 2 < cloud.xyz.size(); i += 3) {
    const float x = cloud.xyz[i];
    const float y = cloud.xyz[i + 1];
    const float z = cloud.xyz[i + 2];
    const float value = isPerspective(projection) ? std::abs(z) : std::hypot(x, y, z);
    depth.data.push_back(std::isfinite(value) && value > 0.0F ? value : 0.0F);
  }
  return depth;
}

LoadedFrame loadCloud(const SegmentInput& input) {
  OrganizedCloud cloud = readOrganizedPcd(input.path);
  LoadedFrame loaded;
  loaded.width = cloud.width;
  loaded.height = cloud.height;
  loaded.projection = detectProjection(cloud.xyz.data(), 3, cloud.width, cloud.height);
  loaded.depth = depthOfCloud(cloud, loaded.projection);
  loaded.xyz = std::move(cloud.xyz);
  return loaded;
}

CameraFile cameraFor(const SegmentInput& input, const SegmentOptions& options, int width, int height) {
  if (!options.camera) return readCameraJson(input.camera_file);
  CameraFile file;
  file.camera =
      PinholeCamera{width, height, options.camera->fx, options.camera->fy, options.camera->cx, options.camera->cy};
  file.depth_scale = options.camera->depth_scale;
  return file;
}

LoadedFrame loadDepth(const SegmentInput& input, const SegmentOptions& options) {
  const LabelImage raw = readGray16(input.path);
  const CameraFile file = cameraFor(input, options, raw.width, raw.height);
  if (file.camera.width != raw.width || file.camera.height != raw.height) {
    throw InputError(input.path, "size",
                     sizeText(raw.width, raw.height) + ", but the camera " + input.camera_file + " has " +
                         sizeText(file.camera.width, file.camera.height));
  }
  LoadedFrame loaded;
  loaded.width = raw.width;
  loaded.height = raw.height;
  loaded.camera = file.camera;
  loaded.depth = depthFromPng(raw, file.depth_scale);
  loaded.noise = file.noise;
  return loaded;
}

}  // namespace

LoadedFrame loadInput(const SegmentInput& input, const SegmentOptions& options) {
  return input.is_cloud ? loadCloud(input) : loadDepth(input, options);
}

InputList listInputs(const SegmentOptions& options) {
  InputList list;
  list.several = options.inputs.size() > 1;
  for (const std::string& path : options.inputs) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
      list.several = true;
      const std::vector<SegmentInput> frames = describeFolder(path, options);
      list.inputs.insert(list.inputs.end(), frames.begin(), frames.end());
    } else {
      list.inputs.push_back(describe(path, options));
    }
  }
  for (SegmentInput& input : list.inputs) {
    if (!lacksCamera(input)) continue;
    if (options.camera_file.empty()) refuse(input, "camera", "there is no " + input.camera_file + " beside it");
    if (!list.several && options.camera_file.empty()) {
      list.usage_problem = input.path + ": camera: none given and no " + input.camera_file +
                           "; use --camera or --fx --fy --cx --cy --depth-scale";
    }
  }
  return list;
}

DepthFrame LoadedFrame::frame() const {
  return xyz.empty() ? DepthFrame::fromDepth(depth.data.data(), camera)
                     : DepthFrame::fromPoints(xyz.data(), 3, width, height, projection);
}

}  // namespace epcc
