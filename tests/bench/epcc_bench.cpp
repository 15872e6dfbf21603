// SPDX-License-Identifier: BSD-3-Clause
// epcc_bench: milliseconds a frame of both modes, the sensor estimation and PCL's organized multi-plane segmentation.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <cstring>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "baselines/registry.h"
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "tests/bench/bench_frame.h"

namespace {

using epcc::bench::BenchFrame;
using epcc::bench::benchFrame;

/// What no method can go below: every depth read, one label written a pixel.
void floorOfTheFrame(benchmark::State& state, int width, int height) {
  const std::vector<float>& depth = benchFrame(width, height).data.depth.data;
  std::vector<std::int32_t> labels(depth.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < depth.size(); ++i) labels[i] = depth[i] > 0.0f ? 1 : 0;
    benchmark::DoNotOptimize(labels.data());
    benchmark::ClobberMemory();
  }
}

/// A whole frame; the stages' mean milliseconds are the counters.
void extract(benchmark::State& state, int width, int height, epcc::Parameters parameters, int threads) {
  const BenchFrame& frame = benchFrame(width, height);
  parameters.threads = threads;
  epcc::PlaneExtractor extractor(parameters, frame.sensor);
  epcc::PlaneSegmentation result;
  epcc::StageTimes sum;
  for (auto _ : state) {
    if (!extractor.extract(frame.view(), result)) return state.SkipWithError(extractor.error().c_str());
    sum.read += extractor.times().read;
    sum.lines += extractor.times().lines;
    sum.planes += extractor.times().planes;
    sum.regions += extractor.times().regions;
    sum.result += extractor.times().result;
  }
  const auto mean = [](double seconds) {
    return benchmark::Counter(1e3 * seconds, benchmark::Counter::kAvgIterations);
  };
  state.counters["read"] = mean(sum.read);
  state.counters["lines"] = mean(sum.lines);
  state.counters["planes"] = mean(sum.planes);
  state.counters["regions"] = mean(sum.regions);
  state.counters["result"] = mean(sum.result);
}

/// The sensor measured in the frame itself (`--noise auto`).
void measureSensor(benchmark::State& state, int width, int height) {
  const BenchFrame& frame = benchFrame(width, height);
  for (auto _ : state) benchmark::DoNotOptimize(epcc::estimateSensor(frame.view()));
}

/// A method of the comparison, with all it does to the frame.
void segment(benchmark::State& state, int width, int height, const std::string& method) {
  const BenchFrame& frame = benchFrame(width, height);
  const auto segmenter = epcc::makeSegmenter(method);
  const epcc::SegmenterInput input{frame.view(), frame.sensor, "bench"};
  epcc::PlaneSegmentation result;
  for (auto _ : state)
    if (!segmenter->segment(input, result)) return state.SkipWithError(segmenter->error().c_str());
}

template <typename Run>
void add(const std::string& name, const Run& run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
}

void addSize(int width, int height) {
  const std::string size = "/" + std::to_string(width) + "x" + std::to_string(height);
  const epcc::SegmenterOptions options = epcc::defaultParameters();
  const auto extraction = [=](const epcc::Parameters& parameters, int threads) {
    return [=](benchmark::State& state) { extract(state, width, height, parameters, threads); };
  };
  add("Floor" + size, [=](benchmark::State& state) { floorOfTheFrame(state, width, height); });
  add("Auto" + size, [=](benchmark::State& state) { measureSensor(state, width, height); });
  add("Paper" + size, extraction(options.epcc_paper, 1));
  add("Paper" + size + "/threads:2", extraction(options.epcc_paper, 2));
  add("Default" + size, extraction(options.epcc, 1));
  add("Default" + size + "/threads:2", extraction(options.epcc, 2));
  add("PclOrganizedMultiPlane" + size, [=](benchmark::State& state) { segment(state, width, height, "omps"); });
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (std::strcmp(argv[i], "--version") == 0) {
      std::cout << "epcc_bench " << EPCC_VERSION << '\n';
      return 0;
    }
  for (const auto& [width, height] : {std::pair{320, 240}, std::pair{640, 480}, std::pair{1280, 720}})
    addSize(width, height);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
