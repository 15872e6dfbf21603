// SPDX-License-Identifier: BSD-3-Clause
// Which methods are timed on which frames.
#include "tests/bench/cases.h"

#include <benchmark/benchmark.h>

#include "baselines/registry.h"
#include "epcc_segmentation/vector_unit.h"
#include "tests/bench/bench_frames.h"
#include "tests/bench/floors.h"
#include "tests/bench/methods.h"

namespace epcc::bench {

namespace {

constexpr int kMaxPeerPixels = 1920 * 1080;  // beyond, only our own methods
constexpr int kMaxSlowPixels = 320 * 240;    // of methods that take seconds
constexpr int kMaxStride = 4;

void add(const std::string& name, const std::function<void(benchmark::State&)>& run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
}

void addExtraction(const std::string& name, const FrameOf& frame, const Extraction& how) {
  add(name, [=](benchmark::State& state) { extraction(state, frame, how); });
}

void addPeer(const std::string& name, const FrameOf& frame, const std::string& method) {
  add(name, [=](benchmark::State& state) { comparedMethod(state, frame, method); });
}

Extraction withThreads(Extraction how, int threads) {
  how.parameters.threads = threads;
  return how;
}

Extraction withSensor(Extraction how, Extraction::Sensor sensor) {
  how.sensor = sensor;
  return how;
}

Extraction defaultMode() {
  Extraction how;
  how.parameters = defaultParameters().epcc;
  return how;
}

Extraction paperMode() {
  Extraction how;
  how.parameters = defaultParameters().epcc_paper;
  return how;
}

/// Whole frames by the extractor and the PCL class.
void addOwnMethods(const std::string& place, const FrameOf& frame) {
  addExtraction("Paper" + place, frame, paperMode());
  addExtraction("Paper" + place + "/threads:2", frame, withThreads(paperMode(), 2));
  addExtraction("Default" + place, frame, defaultMode());
  addExtraction("Default" + place + "/threads:2", frame, withThreads(defaultMode(), 2));
  addExtraction("Auto" + place, frame, withSensor(defaultMode(), Extraction::Sensor::Single));
  addExtraction("AutoStream" + place, frame, withSensor(defaultMode(), Extraction::Sensor::Settled));
  add("PclClass" + place, [=](benchmark::State& state) { pclClass(state, frame); });
  add("PclClassRGB" + place, [=](benchmark::State& state) { pclClassWithColours(state, frame); });
}

void addVariants(const std::string& place, const FrameOf& frame) {
  Extraction how = defaultMode();
  how.units = true;
  addExtraction("Default" + place + "/uint16", frame, how);
  for (int stride = 1; stride <= kMaxStride; ++stride) {
    how = defaultMode();
    how.parameters.inverse_depth.stride = stride;
    addExtraction("Default" + place + "/stride:" + std::to_string(stride), frame, how);
  }
}

void addSize(int width, int height) {
  const std::string place = "/" + std::to_string(width) + "x" + std::to_string(height);
  const FrameOf frame = renderedFrame(width, height);
  add("Floor" + place, [=](benchmark::State& state) { readAndWrite(state, frame); });
  add("FloorWeights" + place, [=](benchmark::State& state) { inverseDepthsAndWeights(state, frame); });
  add("FloorStatistics" + place, [=](benchmark::State& state) { lineStatistics(state, frame); });
  add("Sensor" + place, [=](benchmark::State& state) { sensorEstimation(state, frame); });
  addOwnMethods(place, frame);
  addVariants(place, frame);
  if (width * height <= kMaxPeerPixels) addPeer("PclOrganizedMultiPlane" + place, frame, "omps");
  if (width * height > kMaxSlowPixels) return;
  addPeer("PclRegionGrowing" + place, frame, "region-growing");
  addPeer("PclRansac" + place, frame, "ransac");
}

void addVectorUnits(int width, int height) {
  const std::string place = "/" + std::to_string(width) + "x" + std::to_string(height) + "/unit:";
  const FrameOf frame = renderedFrame(width, height);
  for (const std::string& unit : vectorUnits())
    for (Extraction how : {paperMode(), defaultMode()}) {
      how.vector_unit = unit;
      addExtraction((how.parameters.mode == Mode::Paper ? "Paper" : "Default") + place + unit, frame, how);
    }
}

/// What a frame costs as its noise, its clutter and the number of its planes grow.
void addCurves(int width, int height) {
  for (const auto& [name, factor] : {std::pair{"x0.5", 0.5}, {"x1", 1.0}, {"x2", 2.0}, {"x4", 4.0}})
    addExtraction(std::string("Noise/") + name, renderedFrame(width, height, "b", factor), defaultMode());
  for (const char* scene : {"a", "b", "c", "d"})
    addExtraction(std::string("Scene/") + scene, renderedFrame(width, height, scene), defaultMode());
  for (const int k : {2, 4, 6, 8})
    addExtraction("Scene/facets-" + std::to_string(k * k), facetFrame(width, height, k), defaultMode());
  for (const int percent : {10, 30, 60})
    addExtraction("Scene/clutter-" + std::to_string(percent), clutterFrame(width, height, percent), defaultMode());
}

}  // namespace

void addRenderedCases() {
  for (const auto& [width, height] :
       {std::pair{320, 240}, std::pair{640, 480}, std::pair{1280, 720}, std::pair{1920, 1080}, std::pair{4096, 3000}})
    addSize(width, height);
  addVectorUnits(640, 480);
  addCurves(640, 480);
}

void addFolderCases(const std::string& folder) {
  for (const auto& [name, frame] : framesOfFolder(folder)) {
    const std::string place = "/frames/" + name;
    addOwnMethods(place, frame);
    addPeer("PclOrganizedMultiPlane" + place, frame, "omps");
  }
}

}  // namespace epcc::bench
