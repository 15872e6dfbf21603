// SPDX-License-Identifier: BSD-3-Clause
// A frame is rendered when it is first read; whoever comes for it later gets the same one.
#include "datasets/rendered/rendered_scenes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "datasets/rendered/scene.h"

namespace epcc {

RenderedFrames::RenderedFrames(const std::string& dataset, std::uint64_t first_seed, std::size_t count,
                               const Make& make)
    : dataset_(dataset), first_seed_(first_seed), make_(make), slots_(count) {}

std::string RenderedFrames::name(std::size_t index) const {
  return dataset_ + "_" + std::to_string(first_seed_ + index);
}

LabelledFrame RenderedFrames::read(std::size_t index) const {
  Slot& slot = slots_.at(index);
  std::call_once(slot.once, [&] { slot.frame = make_(first_seed_ + index); });
  return slot.frame;
}

RenderedFrames::Make sceneWithNoise(const std::string& scene, const NoiseOptions& noise) {
  if (sceneSurfaces(scene) == 0) throw std::invalid_argument("unknown scene '" + scene + "'; use a, b, c or d");
  return [scene, noise](std::uint64_t seed) {
    LabelledFrame frame = renderScene(scene, seed);
    applyNoise(frame, noise, seed);
    return frame;
  };
}

RenderedFrames::Make wallWithNoise(double distance, double degrees, const NoiseOptions& noise) {
  return [=](std::uint64_t seed) {
    LabelledFrame frame;
    const PinholeCamera camera = sceneCamera();
    frame.name = "wall_" + std::to_string(std::lround(1000.0 * distance)) + "_" + std::to_string(seed);
    frame.camera.camera = camera;
    frame.depth = DepthImage(camera.width, camera.height);
    frame.labels = LabelImage(camera.width, camera.height, 1);
    const double slope = std::tan(degrees * M_PI / 180.0);
    for (int row = 0; row < camera.height; ++row)
      for (int column = 0; column < camera.width; ++column) {
        const double ray = (column - camera.cx) / camera.fx;
        frame.depth.at(row, column) = static_cast<float>(distance / (1.0 + slope * ray));
      }
    applyNoise(frame, noise, seed);
    return frame;
  };
}

}  // namespace epcc
