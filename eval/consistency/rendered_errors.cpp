// SPDX-License-Identifier: BSD-3-Clause
// Adds noise fields or the error of a stereo camera to exact renderings.
#include "eval/consistency/rendered_errors.h"

#include "datasets/noise/noise_field.h"
#include "datasets/noise/sensor_noise.h"
#include "datasets/rendered/scene.h"

namespace epcc {

namespace {

constexpr double kFloor = 0.001, kGrowth = 0.002;  // sigma_z^2 = (1 mm)^2 + (2 mm z^2)^2
constexpr double kWhite = 0.4;                     // the length of a model whose pixels are independent
constexpr std::uint64_t kStream = 7;

}  // namespace

std::vector<RenderedError> renderedErrors() {
  const StereoNoise stereo;
  // One length for blotches and bending: that of a single Gaussian that is worth as many pixels.
  constexpr double kStereoLength = 9.5;
  return {{"white", SensorModel::axial(kFloor, kGrowth, kWhite)},
          {"2 pixels", SensorModel::axial(kFloor, kGrowth, 2.0)},
          {"4 pixels", SensorModel::axial(kFloor, kGrowth, 4.0)},
          {"stereo", SensorModel::axial(stereo.sigma_floor, stereo.sigma_w, kStereoLength), true}};
}

KnownScene::KnownScene(const std::string& name) : exact(renderScene(name, 1)) {
  for (const auto& plane : exact.camera.extra["planes"]) {
    Vector4 coefficients;
    for (int k = 0; k < 4; ++k) coefficients(k) = plane["coefficients"][static_cast<std::size_t>(k)];
    planes[plane["id"]] = coefficients / coefficients.head<3>().norm();
  }
}

LabelledFrame KnownScene::rendering(const RenderedError& error, int run) const {
  LabelledFrame frame = exact;
  const auto seed = static_cast<std::uint64_t>(run);
  if (error.is_stereo) {
    NoiseOptions options;
    options.kind = NoiseKind::Stereo;
    applyNoise(frame, options, seed);
    return frame;
  }
  SceneRandom random(seed, kStream);
  const double length = error.sensor.correlationLength() > kWhite ? error.sensor.correlationLength() : 0.0;
  const Image<float> field = noiseField(frame.depth.width, frame.depth.height, length, random);
  for (std::size_t i = 0; i < field.data.size(); ++i) {
    float& z = frame.depth.data[i];
    if (z > 0.0f) z += static_cast<float>(error.sensor.sigmaZ(z)) * field.data[i];
  }
  return frame;
}

}  // namespace epcc
