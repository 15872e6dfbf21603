// SPDX-License-Identifier: BSD-3-Clause
// Times the extractor and the methods of the comparison.
#include "tests/bench/methods.h"

#include <memory>

#include "baselines/registry.h"
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "epcc_segmentation/vector_unit.h"

namespace epcc::bench {

namespace {

constexpr int kFramesToSettle = 20;  // more than SensorEstimator remembers

/// Uses another vector unit while it lives.
class VectorUnit {
 public:
  explicit VectorUnit(const std::string& name) : before_(vectorUnit()) {
    if (!name.empty()) setVectorUnit(name);
  }
  VectorUnit(const VectorUnit&) = delete;
  VectorUnit& operator=(const VectorUnit&) = delete;
  ~VectorUnit() { setVectorUnit(before_); }

 private:
  std::string before_;
};

benchmark::Counter meanMilliseconds(double seconds) {
  return benchmark::Counter(1e3 * seconds, benchmark::Counter::kAvgIterations);
}

void addTo(StageTimes& sum, const StageTimes& times) {
  sum.read += times.read;
  sum.sensor += times.sensor;
  sum.lines += times.lines;
  sum.planes += times.planes;
  sum.regions += times.regions;
  sum.result += times.result;
}

void count(benchmark::State& state, const StageTimes& sum, bool measured) {
  state.counters["read"] = meanMilliseconds(sum.read);
  if (measured) state.counters["sensor"] = meanMilliseconds(sum.sensor);
  state.counters["lines"] = meanMilliseconds(sum.lines);
  state.counters["planes"] = meanMilliseconds(sum.planes);
  state.counters["regions"] = meanMilliseconds(sum.regions);
  state.counters["result"] = meanMilliseconds(sum.result);
}

}  // namespace

void extraction(benchmark::State& state, const FrameOf& frame, const Extraction& how) {
  const VectorUnit unit(how.vector_unit);
  const bool measured = how.sensor != Extraction::Sensor::Given;
  const DepthFrame view = how.units ? frame().viewOfUnits() : frame().view();
  PlaneExtractor extractor(how.parameters);
  if (!measured) extractor.setSensor(frame().sensor);
  PlaneSegmentation result;
  if (how.sensor == Extraction::Sensor::Settled)
    for (int i = 0; i < kFramesToSettle; ++i) extractor.extract(view, result);
  StageTimes sum;
  for (auto _ : state) {
    if (how.sensor == Extraction::Sensor::Single) extractor.setSensorAuto();
    if (!extractor.extract(view, result)) return state.SkipWithError(extractor.error().c_str());
    addTo(sum, extractor.times());
  }
  count(state, sum, measured);
  state.counters["found"] = static_cast<double>(result.planes.size());
}

void sensorEstimation(benchmark::State& state, const FrameOf& frame) {
  const DepthFrame view = frame().view();
  for (auto _ : state) benchmark::DoNotOptimize(estimateSensor(view));
}

void comparedMethod(benchmark::State& state, const FrameOf& frame, const std::string& method) {
  const auto segmenter = makeSegmenter(method);
  const SegmenterInput input{frame().view(), frame().sensor, "bench"};
  PlaneSegmentation result;
  double itself = 0.0, conversion = 0.0, fit = 0.0;
  for (auto _ : state) {
    if (!segmenter->segment(input, result)) return state.SkipWithError(segmenter->error().c_str());
    itself += segmenter->seconds();
    conversion += segmenter->conversionSeconds();
    fit += segmenter->fitSeconds();
  }
  state.counters["itself"] = meanMilliseconds(itself);
  state.counters["conversion"] = meanMilliseconds(conversion);
  state.counters["fit"] = meanMilliseconds(fit);
  state.counters["found"] = static_cast<double>(result.planes.size());
}

}  // namespace epcc::bench
