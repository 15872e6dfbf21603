// SPDX-License-Identifier: BSD-3-Clause
// Grey values become depths by one of two calibrations, which the number of the image tells.
#include "datasets/sources/abw_folder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>

#include "datasets/files/sun_raster.h"
#include "datasets/support/folder_listing.h"
#include "datasets/support/input_error.h"

namespace epcc {

namespace {

const char kRange[] = ".range";
const char kLabels[] = ".gt-seg";
constexpr int kSide = 512;
constexpr double kAspect = 1.4508;  // fy / fx
constexpr double kCentre = 255.0;
constexpr double kDepthUnit = 2e-5;  // metres; fine enough for the sensor's 1.3 mm, and 16 bits hold 1.3 m

/// depth in millimetres = grey / scale + offset; fx in pixels. From range-to-coords.c of the comparison.
struct Calibration {
  double offset, scale, fx;
};
constexpr Calibration kCommon = {771.016866, 0.791686, 1586.072821};
constexpr Calibration kOther = {785.410786, 0.773545, 1610.981722};
constexpr std::array<int, 7> kOtherTestImages = {0, 19, 21, 25, 27, 28, 29};

/// The number behind `prefix` that ends the name, -1 if it is not of this form.
int numberBehind(const std::string& name, const std::string& prefix) {
  if (name.rfind(prefix, 0) != 0) return -1;
  int number = -1;
  const char* const end = name.data() + name.size();
  const auto parsed = std::from_chars(name.data() + prefix.size(), end, number);
  return parsed.ec == std::errc() && parsed.ptr == end && number >= 0 ? number : -1;
}

/// The comparison's program gives the second calibration to seven test images and the first to all others.
Calibration calibrationOf(const std::string& path, const std::string& name) {
  const int test = numberBehind(name, "abw.test.");
  if (test < 0 && numberBehind(name, "abw.train.") < 0)
    throw InputError(path, "name", "is not abw.test.N or abw.train.N, by which the calibration is known");
  const bool other = std::find(kOtherTestImages.begin(), kOtherTestImages.end(), test) != kOtherTestImages.end();
  return other ? kOther : kCommon;
}

}  // namespace

bool isAbwFolder(const std::string& folder) {
  const std::string file = anyFileEndingIn(folder, kRange);
  return !file.empty() && isSunRaster(file);
}

AbwFolder::AbwFolder(const std::string& folder)
    : NamedFrames(folder, filesEndingIn(folder, kRange), "image NAME.range") {}

std::vector<std::string> AbwFolder::files(std::size_t index) const {
  return {path(index, kRange), path(index, kLabels)};
}

LabelledFrame AbwFolder::read(std::size_t index) const {
  LabelledFrame frame;
  frame.name = name(index);
  const std::string range_path = path(index, kRange);
  const Calibration calibration = calibrationOf(range_path, frame.name);
  const Image<std::uint8_t> grey = readSunRaster(range_path);
  if (grey.width != kSide || grey.height != kSide) throw InputError(range_path, "size", "is not 512x512");
  frame.camera.camera = {kSide, kSide, calibration.fx, kAspect * calibration.fx, kCentre, kCentre};
  frame.camera.depth_scale = kDepthUnit;
  frame.camera.noise = "structured-light";
  frame.depth = DepthImage(kSide, kSide);
  for (std::size_t i = 0; i < grey.data.size(); ++i)
    if (grey.data[i] != 0)
      frame.depth.data[i] = static_cast<float>(0.001 * (grey.data[i] / calibration.scale + calibration.offset));
  const std::string labels_path = path(index, kLabels);
  std::error_code code;
  if (!std::filesystem::exists(labels_path, code)) return frame;
  frame.labels = readSegcompLabels(labels_path);
  if (frame.labels.width != kSide || frame.labels.height != kSide)
    throw InputError(labels_path, "size", "is not 512x512");
  for (std::size_t i = 0; i < grey.data.size(); ++i)
    if (grey.data[i] == 0) frame.labels.data[i] = 0;
  return frame;
}

}  // namespace epcc
