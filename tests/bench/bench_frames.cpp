// SPDX-License-Identifier: BSD-3-Clause
// Renders or reads the timed frames when they are first asked for.
#include "tests/bench/bench_frames.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "datasets/noise/sensor_noise.h"
#include "datasets/rendered/scene.h"
#include "datasets/sources/dataset_registry.h"
#include "datasets/support/input_error.h"
#include "datasets/support/scene_random.h"
#include "epcc_segmentation/sensor_estimation.h"

namespace epcc::bench {

namespace {

constexpr std::uint64_t kSeed = 1;

FrameOf madeOnce(const std::function<BenchFrame()>& make) {
  const auto frame = std::make_shared<std::unique_ptr<BenchFrame>>();
  return [=]() -> const BenchFrame& {
    if (!*frame) {
      *frame = std::make_unique<BenchFrame>(make());
      BenchFrame& made = **frame;
      if (made.data.scan.empty())
        for (const float z : made.data.depth.data) {
          const double units = std::round(static_cast<double>(z) / made.data.camera.depth_scale);
          made.units.push_back(units > 0.0 && units <= 65535.0 ? static_cast<std::uint16_t>(units) : std::uint16_t{0});
        }
    }
    return **frame;
  };
}

LabelledFrame exactScene(int width, int height, const std::string& scene) {
  SceneOptions options;
  options.camera = sceneCamera(width, height);
  return renderScene(scene, kSeed, options);
}

BenchFrame withNoise(LabelledFrame data, double noise) {
  NoiseOptions options = parseNoise("stereo").value();
  options.stereo.sigma_w *= noise;
  options.stereo.sigma_floor *= noise;
  applyNoise(data, options, kSeed);
  BenchFrame frame;
  const SensorModel preset = SensorModel::preset(options.preset).value();
  const auto k = preset.coefficients();
  frame.sensor = SensorModel::axial(noise * k[0], noise * k[1], preset.correlationLength());
  frame.data = std::move(data);
  return frame;
}

/// Replaces the inverse depths of the frame by w(row, column, w), 0 = invalid.
template <typename Value>
void changeInverseDepths(LabelledFrame& frame, const Value& value) {
  for (int row = 0; row < frame.depth.height; ++row)
    for (int column = 0; column < frame.depth.width; ++column) {
      float& z = frame.depth.at(row, column);
      const double w = value(row, column, z > 0.0f ? 1.0 / static_cast<double>(z) : 0.0);
      z = w > 0.0 ? static_cast<float>(1.0 / w) : 0.0f;
    }
}

struct Facet {
  double w, along_u, along_v;
};

}  // namespace

DepthFrame BenchFrame::viewOfUnits() const {
  const PinholeCamera& camera = data.camera.camera;
  return DepthFrame::fromDepth(
      DepthView<std::uint16_t>{units.data(), camera.width, camera.height, 0, data.camera.depth_scale}, camera);
}

FrameOf renderedFrame(int width, int height, const std::string& scene, double noise) {
  return madeOnce([=] { return withNoise(exactScene(width, height, scene), noise); });
}

FrameOf facetFrame(int width, int height, int k) {
  return madeOnce([=] {
    SceneRandom random(kSeed, 0);
    std::vector<Facet> facets;
    for (int i = 0; i < k * k; ++i)
      facets.push_back({random.uniform(0.4, 0.8), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)});
    LabelledFrame data = exactScene(width, height, "b");
    data.name = "facets";
    const PinholeCamera& camera = data.camera.camera;
    changeInverseDepths(data, [&](int row, int column, double) {
      const int tile_row = row * k / height, tile_column = column * k / width;
      const Facet& facet = facets[static_cast<std::size_t>(tile_row * k + tile_column)];
      const double u = (column - (tile_column + 0.5) * width / k) / camera.fx;
      const double v = (row - (tile_row + 0.5) * height / k) / camera.fy;
      return std::max(0.1, facet.w + facet.along_u * u + facet.along_v * v);
    });
    return withNoise(std::move(data), 0.25);  // small facets drown in more
  });
}

FrameOf clutterFrame(int width, int height, int percent) {
  return madeOnce([=] {
    constexpr int kBlock = 16;
    BenchFrame frame = withNoise(exactScene(width, height, "b"), 1.0);
    SceneRandom random(kSeed, 0);
    const int blocks_across = width / kBlock + 1;
    std::vector<double> size;  // of the clutter in each block, a share of the inverse depth
    for (int i = 0; i < blocks_across * (height / kBlock + 1); ++i)
      size.push_back(random.uniform(0.0, 100.0) < percent ? random.uniform(0.05, 0.15) : 0.0);
    changeInverseDepths(frame.data, [&](int row, int column, double w) {
      const double s = size[static_cast<std::size_t>(row / kBlock * blocks_across + column / kBlock)];
      return w * (1.0 + s * (1.0 + std::sin(0.9 * column) * std::sin(0.7 * row)));
    });
    return frame;
  });
}

std::vector<std::pair<std::string, FrameOf>> framesOfFolder(const std::string& folder) {
  const std::shared_ptr<FrameSource> source = openDataset(folder);
  std::vector<std::pair<std::string, FrameOf>> frames;
  for (std::size_t i = 0; i < source->size(); ++i)
    frames.emplace_back(source->name(i), madeOnce([=] {
                          BenchFrame frame;
                          frame.data = source->read(i);
                          const auto& noise = frame.data.camera.noise;
                          std::string why;
                          const auto named = noise ? SensorModel::parse(*noise, &why) : std::nullopt;
                          if (noise && !named) throw InputError(folder + "/" + source->name(i), "noise", why);
                          frame.sensor = named ? *named : estimateSensor(frame.view()).model();
                          return frame;
                        }));
  return frames;
}

}  // namespace epcc::bench
