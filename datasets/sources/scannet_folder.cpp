// SPDX-License-Identifier: BSD-3-Clause
// Reads the 4x4 matrix of the depth camera and lists the frames.
#include "datasets/sources/scannet_folder.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include "datasets/sources/depth_image_folder.h"
#include "datasets/support/input_error.h"
#include "datasets/support/number_text.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxMatrixBytes = 4096;

std::string matrixPath(const std::string& folder) {
  return (fs::path(folder) / "intrinsic" / "intrinsic_depth.txt").string();
}

/// Sixteen numbers and nothing else.
std::array<double, 16> readMatrix(const std::string& path) {
  if (inputFileSize(path) > kMaxMatrixBytes) throw InputError(path, "file", "is too long for a 4x4 matrix");
  std::ifstream in(path);
  std::array<double, 16> matrix{};
  std::string word;
  for (double& value : matrix) {
    if (!(in >> word)) throw InputError(path, "matrix", "has fewer than 16 numbers");
    const std::optional<double> number = numberFrom(word);
    if (!number || !std::isfinite(*number)) throw InputError(path, "matrix", "'" + word + "' is not a number");
    value = *number;
  }
  if (in >> word) throw InputError(path, "matrix", "has more than 16 numbers");
  return matrix;
}

PinholeCamera readCamera(const std::string& path) {
  const std::array<double, 16> m = readMatrix(path);
  if (!(m[0] > 0.0 && m[5] > 0.0)) throw InputError(path, "matrix", "the focal lengths are not positive");
  for (const std::size_t zero : {1, 4, 8, 9})
    if (m[zero] != 0.0) throw InputError(path, "matrix", "is not that of a camera without skew");
  if (m[10] != 1.0) throw InputError(path, "matrix", "the third number of the third row is not 1");
  return {0, 0, m[0], m[5], m[2], m[6]};
}

}  // namespace

bool isScannetFolder(const std::string& folder) {
  std::error_code code;
  return fs::is_directory(fs::path(folder) / "depth", code) && fs::is_regular_file(matrixPath(folder), code);
}

std::unique_ptr<FrameSource> openScannetFolder(const std::string& folder) {
  DepthImages images;
  images.folder = folder;
  images.depth_files = depthImagesIn(folder, "depth");
  images.camera.camera = readCamera(matrixPath(folder));
  images.camera.depth_scale = 0.001;
  images.camera.noise = "structure-sensor";
  return std::make_unique<DepthImageFolder>(std::move(images),
                                            firstFolder(folder, {"planes", "labels", "annotation/segmentation"}));
}

}  // namespace epcc
