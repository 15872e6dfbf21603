// SPDX-License-Identifier: BSD-3-Clause
// Lists, reads and writes labelled frames.
#include "datasets/files/labelled_frame.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "datasets/files/png_io.h"
#include "datasets/support/input_error.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;
const std::string kDepthEnding = "_depth.png";

std::string pathOf(const std::string& folder, const std::string& name, const char* ending) {
  return (fs::path(folder) / (name + ending)).string();
}

void checkSize(const std::string& path, const Image<std::uint16_t>& image, const PinholeCamera& camera) {
  if (image.width == camera.width && image.height == camera.height) return;
  throw InputError(path, "size",
                   std::to_string(image.width) + "x" + std::to_string(image.height) + ", but the camera file says " +
                       std::to_string(camera.width) + "x" + std::to_string(camera.height));
}

/// Nothing is written that could not be read back.
template <typename T>
void checkSizeToWrite(const std::string& path, const Image<T>& image, const PinholeCamera& camera) {
  if (image.width != camera.width || image.height != camera.height)
    throw OutputError(path, "size", "is not that of the camera");
}

}  // namespace

DepthFrame frameView(const LabelledFrame& frame) {
  if (frame.scan.empty()) return DepthFrame::fromDepth(frame.depth.data.data(), frame.camera.camera);
  return DepthFrame::fromPoints(frame.scan.data(), 3, frame.depth.width, frame.depth.height, frame.projection);
}

std::vector<std::string> listLabelledFrames(const std::string& folder) {
  std::error_code code;
  fs::directory_iterator entries(folder, code);
  if (code) throw InputError(folder, "folder", code.message());
  std::vector<std::string> names;
  for (; entries != fs::directory_iterator(); entries.increment(code)) {
    const std::string file = entries->path().filename().string();
    if (file.size() > kDepthEnding.size() &&
        file.compare(file.size() - kDepthEnding.size(), kDepthEnding.size(), kDepthEnding) == 0)
      names.push_back(file.substr(0, file.size() - kDepthEnding.size()));
  }
  if (code) throw InputError(folder, "folder", code.message());
  std::sort(names.begin(), names.end());
  return names;
}

LabelledFrame readLabelledFrame(const std::string& folder, const std::string& name) {
  LabelledFrame frame;
  frame.name = name;
  frame.camera = readCameraJson(pathOf(folder, name, ".json"));
  const std::string depth_path = pathOf(folder, name, kDepthEnding.c_str());
  const auto raw = readGray16(depth_path);
  checkSize(depth_path, raw, frame.camera.camera);
  frame.depth = depthFromPng(raw, frame.camera.depth_scale);
  const std::string labels_path = pathOf(folder, name, "_labels.png");
  std::error_code code;
  if (fs::exists(labels_path, code)) {
    frame.labels = readGray16(labels_path);
    checkSize(labels_path, frame.labels, frame.camera.camera);
  }
  if (code) throw InputError(labels_path, "file", code.message());
  return frame;
}

void writeLabelledFrame(const std::string& folder, const LabelledFrame& frame) {
  checkSizeToWrite(pathOf(folder, frame.name, kDepthEnding.c_str()), frame.depth, frame.camera.camera);
  if (!frame.labels.empty())
    checkSizeToWrite(pathOf(folder, frame.name, "_labels.png"), frame.labels, frame.camera.camera);
  Image<std::uint16_t> raw(frame.depth.width, frame.depth.height);
  for (std::size_t i = 0; i < raw.data.size(); ++i) {
    const double units = std::round(static_cast<double>(frame.depth.data[i]) / frame.camera.depth_scale);
    raw.data[i] = units >= 1.0 && units <= 65535.0 ? static_cast<std::uint16_t>(units) : std::uint16_t{0};
  }
  writeGray16(pathOf(folder, frame.name, kDepthEnding.c_str()), raw);
  if (!frame.labels.empty()) writeGray16(pathOf(folder, frame.name, "_labels.png"), frame.labels);
  writeCameraJson(pathOf(folder, frame.name, ".json"), frame.camera);
}

DepthImage depthFromPng(const Image<std::uint16_t>& raw, double depth_scale) {
  DepthImage depth(raw.width, raw.height);
  for (std::size_t i = 0; i < raw.data.size(); ++i) depth.data[i] = static_cast<float>(raw.data[i] * depth_scale);
  return depth;
}

}  // namespace epcc
