// SPDX-License-Identifier: BSD-3-Clause
// Every key that the camera needs is checked for its type and range; the others are kept as they are.
#include "datasets/files/camera_json.h"

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

#include "datasets/files/image.h"
#include "datasets/support/atomic_file.h"
#include "datasets/support/input_error.h"
#include "epcc_segmentation/depth_view.h"

namespace epcc {

namespace {

constexpr std::uintmax_t kMaxFileBytes = 16u << 20;
constexpr int kMaxNesting = 100;

std::string readText(const std::string& path) {
  if (inputFileSize(path) > kMaxFileBytes) throw InputError(path, "file", "is larger than 16 MiB");
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw InputError(path, "file", "cannot be read");
  return text.str();
}

double number(const std::string& path, const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end()) throw InputError(path, key, "is missing");
  if (!found->is_number()) throw InputError(path, key, "is not a number");
  const double value = found->get<double>();
  if (!std::isfinite(value)) throw InputError(path, key, "is not finite");
  return value;
}

int imageSide(const std::string& path, const nlohmann::json& json, const char* key) {
  const double value = number(path, json, key);
  if (value != std::floor(value) || value < 1.0 || value > kMaxImageSide)
    throw InputError(path, key, "must be a whole number from 1 to " + std::to_string(kMaxImageSide));
  return static_cast<int>(value);
}

std::optional<std::string> text(const std::string& path, const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || found->is_null()) return std::nullopt;
  if (!found->is_string()) throw InputError(path, key, "is not a text");
  return found->get<std::string>();
}

/// The keys that a camera and a scan have in common; those read are taken away before the rest is kept.
void takeNames(const std::string& path, nlohmann::json& json, CameraFile& file) {
  file.name = text(path, json, "name").value_or("");
  file.noise = text(path, json, "noise");
  for (const char* key : {"name", "noise"}) json.erase(key);
  file.extra = std::move(json);
}

}  // namespace

nlohmann::json readJsonObject(const std::string& path) {
  try {
    std::vector<std::set<std::string>> keys;  // of the objects that are open
    const auto check = [&](int depth, nlohmann::json::parse_event_t event, nlohmann::json& value) {
      using Event = nlohmann::json::parse_event_t;
      if (depth > kMaxNesting) throw InputError(path, "JSON", "is nested too deeply");
      if (event == Event::object_start) keys.emplace_back();
      if (event == Event::object_end) keys.pop_back();
      if (event == Event::key && !keys.back().insert(value.get<std::string>()).second)
        throw InputError(path, value.get<std::string>(), "occurs twice");
      return true;
    };
    const std::string text = readText(path);
    // The parser takes a zero for the end, and would pass over what stands behind it.
    if (text.find('\0') != std::string::npos) throw InputError(path, "JSON", "has a byte that is zero");
    auto json = nlohmann::json::parse(text, check);
    if (!json.is_object()) throw InputError(path, "JSON", "is not an object");
    return json;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(path, "JSON", error.what());
  }
}

double positiveNumber(const std::string& path, const nlohmann::json& json, const char* key) {
  const double value = number(path, json, key);
  if (!(value > 0.0)) throw InputError(path, key, "must be positive");
  return value;
}

CameraFile readCameraJson(const std::string& path) {
  nlohmann::json json = readJsonObject(path);
  CameraFile file;
  file.camera.width = imageSide(path, json, "width");
  file.camera.height = imageSide(path, json, "height");
  if (static_cast<long>(file.camera.width) * file.camera.height > kMaxPixels)
    throw InputError(path, "width", "times height is more than " + std::to_string(kMaxPixels) + " pixels");
  file.camera.fx = positiveNumber(path, json, "fx");
  file.camera.fy = positiveNumber(path, json, "fy");
  file.camera.cx = number(path, json, "cx");
  file.camera.cy = number(path, json, "cy");
  const std::string problem = file.camera.validate();
  if (!problem.empty()) throw InputError(path, "camera", problem);
  file.depth_scale = positiveNumber(path, json, "depth_scale");
  if (file.depth_scale > kMaxDepthScale) throw InputError(path, "depth_scale", "is more than 1000 m a unit");
  for (const char* key : {"width", "height", "fx", "fy", "cx", "cy", "depth_scale"}) json.erase(key);
  takeNames(path, json, file);
  return file;
}

CameraFile readScanJson(const std::string& path) {
  nlohmann::json json = readJsonObject(path);
  CameraFile file;
  takeNames(path, json, file);
  return file;
}

void writeCameraJson(const std::string& path, const CameraFile& file) {
  const std::string problem = file.camera.validate();
  if (!problem.empty()) throw OutputError(path, "camera", problem);
  if (!(std::isfinite(file.depth_scale) && file.depth_scale > 0.0))
    throw OutputError(path, "depth_scale", "must be positive");
  nlohmann::json json = file.extra.is_object() ? file.extra : nlohmann::json::object();
  json["width"] = file.camera.width;
  json["height"] = file.camera.height;
  json["fx"] = file.camera.fx;
  json["fy"] = file.camera.fy;
  json["cx"] = file.camera.cx;
  json["cy"] = file.camera.cy;
  json["depth_scale"] = file.depth_scale;
  if (!file.name.empty()) json["name"] = file.name;
  if (file.noise) json["noise"] = *file.noise;
  writeTextFile(path, json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace epcc
