// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes the three files of a frame, and checks their sizes against each other.
#include "datasets/files/labelled_frame.h"

#include <cmath>
#include <filesystem>

#include "datasets/files/png_io.h"
#include "datasets/support/folder_listing.h"
#include "datasets/support/input_error.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;
const char kDepthEnding[] = "_depth.png";
const char kLabelsEnding[] = "_labels.png";
const char kCameraEnding[] = ".json";
constexpr std::uint16_t kNoDepth = 65535;  // what sensors write where they saw nothing, or too far to be said

std::string pathOf(const std::string& folder, const std::string& name, const char* ending) {
  return (fs::path(folder) / (name + ending)).string();
}

void checkSize(const std::string& path, const Image<std::uint16_t>& image, const PinholeCamera& camera) {
  if (image.width == camera.width && image.height == camera.height) return;
  throw InputError(
      path, "size",
      sizeText(image.width, image.height) + ", but the camera file says " + sizeText(camera.width, camera.height));
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
  return DepthFrame::fromPoints(frame.scan.data(), 3, frame.depth.width, frame.depth.height, frame.geometry);
}

std::vector<std::string> listLabelledFrames(const std::string& folder) {
  return filesEndingIn(folder, kDepthEnding);
}

LabelledFrame readLabelledFrame(const std::string& folder, const std::string& name) {
  LabelledFrame frame;
  frame.name = name;
  frame.camera = readCameraJson(existingFile(pathOf(folder, name, kCameraEnding)));
  const std::string depth_path = existingFile(pathOf(folder, name, kDepthEnding));
  const auto raw = readGray16(depth_path);
  checkSize(depth_path, raw, frame.camera.camera);
  frame.depth = depthFromPng(raw, frame.camera.depth_scale);
  const std::string labels_path = existingFile(pathOf(folder, name, kLabelsEnding));
  std::error_code code;
  if (fs::exists(labels_path, code)) {
    frame.labels = readGray16(labels_path);
    checkSize(labels_path, frame.labels, frame.camera.camera);
  }
  if (code) throw InputError(labels_path, "file", code.message());
  return frame;
}

void writeLabelledFrame(const std::string& folder, const LabelledFrame& frame) {
  checkSizeToWrite(pathOf(folder, frame.name, kDepthEnding), frame.depth, frame.camera.camera);
  if (!frame.labels.empty())
    checkSizeToWrite(pathOf(folder, frame.name, kLabelsEnding), frame.labels, frame.camera.camera);
  Image<std::uint16_t> raw(frame.depth.width, frame.depth.height);
  for (std::size_t i = 0; i < raw.data.size(); ++i) {
    const double units = std::round(static_cast<double>(frame.depth.data[i]) / frame.camera.depth_scale);
    raw.data[i] = units >= 1.0 && units <= 65535.0 ? static_cast<std::uint16_t>(units) : std::uint16_t{0};
  }
  writeGray16(pathOf(folder, frame.name, kDepthEnding), raw);
  if (!frame.labels.empty()) writeGray16(pathOf(folder, frame.name, kLabelsEnding), frame.labels);
  writeCameraJson(pathOf(folder, frame.name, kCameraEnding), frame.camera);
}

DepthImage depthFromPng(const Image<std::uint16_t>& raw, double depth_scale) {
  DepthImage depth(raw.width, raw.height);
  for (std::size_t i = 0; i < raw.data.size(); ++i)
    depth.data[i] = raw.data[i] == kNoDepth ? 0.0F : static_cast<float>(raw.data[i] * depth_scale);
  return depth;
}

}  // namespace epcc
