// SPDX-License-Identifier: BSD-3-Clause
// Renders the timed frames.
#include "tests/bench/bench_frame.h"

#include <map>
#include <utility>

#include "datasets/noise/sensor_noise.h"
#include "datasets/rendered/scene.h"

namespace epcc::bench {

namespace {

BenchFrame render(int width, int height) {
  BenchFrame frame;
  SceneOptions options;
  options.camera = sceneCamera(width, height);
  frame.data = renderScene("b", 1, options);  // boxes on a desk, the scene with most surfaces
  const NoiseOptions noise = parseNoise("stereo").value();
  applyNoise(frame.data, noise, 1);
  frame.sensor = SensorModel::preset(noise.preset).value();
  return frame;
}

}  // namespace

const BenchFrame& benchFrame(int width, int height) {
  static std::map<std::pair<int, int>, BenchFrame> frames;
  const auto size = std::make_pair(width, height);
  const auto found = frames.find(size);
  return found != frames.end() ? found->second : frames.emplace(size, render(width, height)).first->second;
}

}  // namespace epcc::bench
