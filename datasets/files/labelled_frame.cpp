// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes the three files of a frame, and checks their sizes against each other.
#include "datasets/files/labelled_frame.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "datasets/files/cloud_frame.h"
#include "datasets/files/png_io.h"
#include "datasets/support/folder_listing.h"
#include "datasets/support/input_error.h"
#include "epcc_segmentation/doubts.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;
const char kDepthEnding[] = "_depth.png";
const char kLabelsEnding[] = "_labels.png";
const char kCameraEnding[] = ".json";
constexpr std::uint16_t kNoDepth = 65535;  // what sensors write where they saw nothing, or too far to be said
const char kCloudEnding[] = ".pcd";

std::string pathOf(const std::string& folder, const std::string& name, const char* ending) {
  return (fs::path(folder) / (name + ending)).string();
}

bool fileExists(const std::string& path) {
  std::error_code code;
  const bool exists = fs::exists(path, code);
  if (code) throw InputError(path, "file", code.message());
  return exists;
}

void checkSize(const std::string& path, const Image<std::uint16_t>& image, int width, int height,
               const std::string& whose) {
  if (image.width == width && image.height == height) return;
  throw InputError(path, "size",
                   sizeText(image.width, image.height) + ", but " + whose + " " + sizeText(width, height));
}

/// Names of the scans of a folder: clouds with a JSON beside them.
std::vector<std::string> listScans(const std::string& folder) {
  const std::vector<std::string> clouds = filesEndingIn(folder, kCloudEnding);
  if (clouds.empty()) return {};
  const std::vector<std::string> described = filesEndingIn(folder, kCameraEnding);
  std::vector<std::string> scans;
  std::set_intersection(clouds.begin(), clouds.end(), described.begin(), described.end(), std::back_inserter(scans),
                        naturallyBefore);
  return scans;
}

LabelledFrame readScan(const std::string& cloud_path, const std::string& json_path) {
  LabelledFrame frame = readCloud(cloud_path);
  frame.camera = readScanJson(json_path);
  return frame;
}

LabelledFrame readDepthImage(const std::string& depth_path, const std::string& json_path) {
  LabelledFrame frame;
  frame.camera = readCameraJson(json_path);
  const auto raw = readGray16(depth_path);
  checkSize(depth_path, raw, frame.camera.camera.width, frame.camera.camera.height, "the camera file says");
  takeDepth(raw, frame);
  return frame;
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
  const std::vector<std::string> images = filesEndingIn(folder, kDepthEnding);
  const std::vector<std::string> scans = listScans(folder);
  std::vector<std::string> names;
  std::set_union(images.begin(), images.end(), scans.begin(), scans.end(), std::back_inserter(names), naturallyBefore);
  return names;
}

std::string labelledFrameFile(const std::string& folder, const std::string& name) {
  const std::string image = existingFile(pathOf(folder, name, kDepthEnding));
  const std::string cloud = existingFile(pathOf(folder, name, kCloudEnding));
  return !fileExists(image) && fileExists(cloud) ? cloud : image;
}

std::string frameHeld(const std::string& folder, const std::string& name) {
  const std::string file = labelledFrameFile(folder, name);
  const bool is_frame = fileExists(file) && (!hasEnding(file, kCloudEnding) ||
                                             fileExists(existingFile(pathOf(folder, name, kCameraEnding))));
  return is_frame ? std::filesystem::path(file).filename().string() : std::string();
}

LabelledFrame readLabelledFrame(const std::string& folder, const std::string& name) {
  const std::string json_path = existingFile(pathOf(folder, name, kCameraEnding));
  const std::string file = labelledFrameFile(folder, name);
  const bool is_scan = hasEnding(file, kCloudEnding);
  LabelledFrame frame = is_scan ? readScan(file, json_path) : readDepthImage(file, json_path);
  frame.name = name;
  const std::string labels_path = existingFile(pathOf(folder, name, kLabelsEnding));
  if (!fileExists(labels_path)) return frame;
  frame.labels = readGray16(labels_path);
  checkSize(labels_path, frame.labels, frame.depth.width, frame.depth.height,
            is_scan ? "the cloud has" : "the camera file says");
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

void takeDepth(const Image<std::uint16_t>& raw, LabelledFrame& frame) {
  frame.depth = DepthImage(raw.width, raw.height);
  for (std::size_t i = 0; i < raw.data.size(); ++i)
    frame.depth.data[i] = raw.data[i] == kNoDepth ? 0.0F : static_cast<float>(raw.data[i] * frame.camera.depth_scale);
  frame.bytes_are_swapped = bytesAreSwapped({raw.data.data(), raw.width, raw.height});
}

}  // namespace epcc
