// SPDX-License-Identifier: BSD-3-Clause
// Camera files, of depth images and of scans, with the pose and the sensor model in them.
#include <cmath>
#include <nlohmann/json.hpp>

#include "datasets/files/camera_json.h"
#include "datasets/files/frame_pose.h"
#include "epcc_segmentation/sensor_model.h"
#include "tests/fuzz/file_run.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

void checkPose(const CameraFile& file) {
  LabelledFrame frame;
  frame.camera = file;
  try {
    const auto pose = framePose(frame);
    require(!pose || pose->matrix().allFinite(), "a pose is finite");
  } catch (const InputError& error) {
    requireOneLine(error.what());
  }
}

void checkFile(const CameraFile& file) {
  require(file.extra.is_object(), "what is left is an object");
  std::string why;
  if (file.noise && !SensorModel::parse(*file.noise, &why)) require(!why.empty(), "a model is refused in words");
  checkPose(file);
}

bool runCameraJson(const std::uint8_t* data, std::size_t size) {
  takesFile(data, size, [](const std::string& path) { checkFile(readScanJson(path)); });
  return takesFile(data, size, [](const std::string& path) {
    const CameraFile file = readCameraJson(path);
    require(file.camera.validate().empty(), "a camera that was read can be used");
    require(file.depth_scale > 0.0 && std::isfinite(file.depth_scale), "a scale that was read can be used");
    checkFile(file);
  });
}

std::vector<std::string> cameraJsonSeeds() {
  nlohmann::json json = {
      {"width", 640}, {"height", 480},        {"fx", 525.5}, {"fy", 524.5},          {"cx", 319.5},
      {"cy", 239.5},  {"depth_scale", 0.001}, {"name", "a"}, {"noise", "kinect-v1"}, {"planes", {{{"id", 1}}}}};
  std::vector<std::string> seeds = {json.dump()};
  json["noise"] = "poly:0.001,0.002,0.003";
  json["pose"] = {1, 0, 0, 0.5, 0, 1, 0, 0.25, 0, 0, 1, -2.0};
  seeds.push_back(json.dump(1));
  json["noise"] = "0.002,0.001,1.5";
  json["pose"] = {{0, -1, 0, 0.5}, {1, 0, 0, 0.25}, {0, 0, 1, -2.0}};
  seeds.push_back(json.dump());
  return seeds;
}

}  // namespace

const FuzzTarget kCameraJson{runCameraJson, cameraJsonSeeds};

}  // namespace epcc::fuzz
