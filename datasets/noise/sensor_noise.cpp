// SPDX-License-Identifier: BSD-3-Clause
// The words of --noise, and what each does to a frame: nothing, white noise, or the stereo camera's.
#include "datasets/noise/sensor_noise.h"

#include <cmath>

#include "datasets/support/scene_random.h"
#include "datasets/support/text_hash.h"

namespace epcc {
namespace {

constexpr std::uint64_t kWhiteStream = 100;
constexpr double kRegisteredScale = 1.6;  // focal lengths of a D4xx's colour and depth images at 640 px: 617 / 383

void addWhiteNoise(DepthImage& depth, const SensorModel& sensor, double scale, std::uint64_t seed) {
  SceneRandom random(seed, kWhiteStream);
  for (float& z : depth.data) {
    const double error = random.normal();  // drawn for invalid pixels too: a hole changes no other pixel
    if (!(z > 0.0F)) continue;
    const double noisy = static_cast<double>(z) + scale * sensor.sigmaZ(static_cast<double>(z)) * error;
    z = noisy > 0.0 ? static_cast<float>(noisy) : 0.0F;
  }
}

std::optional<NoiseOptions> parseWhite(const std::string& text, std::string* why) {
  const auto sensor = SensorModel::parse(text, why);
  if (!sensor) return std::nullopt;
  NoiseOptions options;
  options.kind = NoiseKind::White;
  options.sensor = *sensor;
  options.preset = text;
  return options;
}

}  // namespace

std::optional<NoiseOptions> parseNoise(const std::string& text, std::string* why) {
  const std::string white = "white:";
  if (text.rfind(white, 0) == 0) return parseWhite(text.substr(white.size()), why);
  NoiseOptions options;
  if (text == "none") return options;
  if (text == "stereo" || text == "stereo-registered") {
    options.kind = NoiseKind::Stereo;
    options.preset = text == "stereo" ? "realsense" : "realsense-registered";
    options.stereo.grid_scale = text == "stereo" ? 1.0 : kRegisteredScale;
    return options;
  }
  if (why != nullptr) *why = "'" + text + "' is none of none, white:SENSOR, stereo, stereo-registered";
  return std::nullopt;
}

void applyNoise(LabelledFrame& frame, const NoiseOptions& options, std::uint64_t seed) {
  seed ^= textHash(frame.name);  // two scenes of one seed do not share their blotches and holes
  if (options.kind == NoiseKind::White) addWhiteNoise(frame.depth, options.sensor, options.scale, seed);
  if (options.kind == NoiseKind::Stereo) {
    StereoNoise stereo = options.stereo;
    stereo.sigma_w *= options.scale;
    stereo.sigma_floor *= options.scale;
    frame.depth = stereoDepth(frame.depth, frame.camera.camera, stereo, seed);
    frame.camera.depth_scale = 0.001;
  }
  frame.camera.noise = options.preset;
}

}  // namespace epcc
