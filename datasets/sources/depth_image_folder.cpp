// SPDX-License-Identifier: BSD-3-Clause
// A label file belongs to the depth image of the same name; both must have the same size.
#include "datasets/sources/depth_image_folder.h"

#include <filesystem>
#include <set>
#include <utility>

#include "datasets/files/npy_labels.h"
#include "datasets/files/png_io.h"
#include "datasets/support/folder_listing.h"
#include "datasets/support/input_error.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;

std::string stem(const std::string& file) {
  return fs::path(file).stem().string();
}

/// Label files of the folder by the depth image's stem; PNG goes before NumPy.
class LabelFiles {
 public:
  LabelFiles(const std::string& folder, const std::string& labels_folder) : labels_folder_(labels_folder) {
    const std::string path = (fs::path(folder) / labels_folder).string();
    for (std::string& name : filesEndingIn(path, ".png")) png_.insert(std::move(name));
    for (std::string& name : filesEndingIn(path, ".npy")) npy_.insert(std::move(name));
  }
  std::string of(const std::string& name) const {
    const char* const ending = png_.count(name) != 0 ? ".png" : npy_.count(name) != 0 ? ".npy" : nullptr;
    return ending == nullptr ? std::string() : (fs::path(labels_folder_) / (name + ending)).string();
  }

 private:
  std::string labels_folder_;
  std::set<std::string> png_, npy_;
};

}  // namespace

std::vector<std::string> depthImagesIn(const std::string& folder, const std::string& sub_folder) {
  std::vector<std::string> files = filesEndingIn((fs::path(folder) / sub_folder).string(), ".png");
  for (std::string& file : files) file = (fs::path(sub_folder) / (file + ".png")).string();
  return files;
}

std::string firstFolder(const std::string& folder, const std::vector<std::string>& candidates) {
  std::error_code code;
  for (const std::string& candidate : candidates)
    if (fs::is_directory(fs::path(folder) / candidate, code)) return candidate;
  return {};
}

DepthImageFolder::DepthImageFolder(DepthImages images, const std::string& labels_folder)
    : folder_(images.folder), dataset_(folderName(images.folder)), camera_(std::move(images.camera)) {
  if (images.depth_files.empty()) throw InputError(folder_, "folder", "has no depth image");
  if (labels_folder.empty()) {
    for (std::string& depth : images.depth_files) files_.push_back({std::move(depth), {}});
    return;
  }
  const LabelFiles labels(folder_, labels_folder);
  for (std::string& depth : images.depth_files) {
    std::string file = labels.of(stem(depth));
    if (!file.empty()) files_.push_back({std::move(depth), std::move(file)});
  }
  if (files_.empty())
    throw InputError((fs::path(folder_) / labels_folder).string(), "folder",
                     "has no PNG or .npy with the name of a depth image, such as " + stem(images.depth_files.front()));
}

std::string DepthImageFolder::name(std::size_t index) const {
  return stem(files_.at(index).depth);
}

std::vector<std::string> DepthImageFolder::files(std::size_t index) const {
  const Files& files = files_.at(index);
  std::vector<std::string> paths = {existingFile((fs::path(folder_) / files.depth).string())};
  if (!files.labels.empty()) paths.push_back(existingFile((fs::path(folder_) / files.labels).string()));
  return paths;
}

LabelledFrame DepthImageFolder::read(std::size_t index) const {
  const std::vector<std::string> paths = files(index);
  LabelledFrame frame;
  frame.name = name(index);
  frame.camera = camera_;
  PinholeCamera& camera = frame.camera.camera;
  const auto raw = readGray16(paths[0]);
  if (camera.width == 0) {
    camera.width = raw.width;
    camera.height = raw.height;
  }
  if (raw.width != camera.width || raw.height != camera.height)
    throw InputError(paths[0], "size",
                     sizeText(raw.width, raw.height) + ", but the camera has " + sizeText(camera.width, camera.height));
  takeDepth(raw, frame);
  if (paths.size() > 1) frame.labels = readLabelFile(paths[1], camera.width, camera.height);
  return frame;
}

LabelImage readLabelFile(const std::string& path, int width, int height) {
  if (hasEnding(path, ".npy")) return readNpyLabels(path, width, height);
  LabelImage labels = readLabelPng(path);
  if (labels.width != width || labels.height != height)
    throw InputError(path, "size",
                     sizeText(labels.width, labels.height) + ", but the depth image has " + sizeText(width, height));
  return labels;
}

}  // namespace epcc
