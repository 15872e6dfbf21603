// SPDX-License-Identifier: BSD-3-Clause
// The camera file beside a depth image.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "epcc_segmentation/depth_frame.h"

namespace epcc {

/// NAME.json of a labelled frame.
struct CameraFile {
  PinholeCamera camera;
  double depth_scale = 0.001;        ///< metres per depth unit
  std::string name;                  ///< key "name", may be empty
  std::optional<std::string> noise;  ///< key "noise": a sensor model as SensorModel::parse takes it
  nlohmann::json extra;              ///< every other key, kept as it is
};

/// An object of at most 16 MiB; InputError for anything else.
nlohmann::json readJsonObject(const std::string& path);
/// Member `key`, which must be a positive number.
double positiveNumber(const std::string& path, const nlohmann::json& json, const char* key);

/// Needs width, height, fx, fy, cx, cy and depth_scale; unknown keys are kept. InputError names the key.
CameraFile readCameraJson(const std::string& path);
/// NAME.json of a scan: name, noise and the rest; there is no camera, and what such keys hold is kept in `extra`.
CameraFile readScanJson(const std::string& path);
void writeCameraJson(const std::string& path, const CameraFile& file);

}  // namespace epcc
