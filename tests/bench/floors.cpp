// SPDX-License-Identifier: BSD-3-Clause
// The floors, in plain loops that the compiler puts into vectors.
#include "tests/bench/floors.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace epcc::bench {

namespace {

/// w = 1/z and 1/sigma_w^2 of the axial sensor model, sigma_w^2 = b^2 + a^2 w^4.
void weigh(const std::vector<float>& depth, const SensorModel& sensor, std::vector<float>& w,
           std::vector<float>& weight) {
  const auto k = sensor.coefficients();
  const auto a2 = static_cast<float>(k[0] * k[0]), b2 = static_cast<float>(k[1] * k[1]);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const bool valid = depth[i] > 0.0f;
    const float inverse = 1.0f / (valid ? depth[i] : 1.0f);
    const float inverse2 = inverse * inverse;
    w[i] = valid ? inverse : 0.0f;
    weight[i] = valid ? 1.0f / (b2 + a2 * inverse2 * inverse2) : 0.0f;
  }
}

/// Weighted means and sums of squares of one line a column.
struct Statistics {
  std::vector<float> weight, x, w, xx, xw;

  explicit Statistics(std::size_t columns) : weight(columns), x(columns), w(columns), xx(columns), xw(columns) {}
  void reset() {
    for (std::vector<float>* sum : {&weight, &x, &w, &xx, &xw}) sum->assign(sum->size(), 0.0f);
    weight.assign(weight.size(), 1e-6f);
  }
};

/// Takes in a row, place `place` of each line: r = t/(W + t), g = W r.
void addRow(const float* sample, const float* sample_weight, float place, std::size_t columns, Statistics& sums) {
  float* weight = sums.weight.data();
  float* x = sums.x.data();
  float* w = sums.w.data();
  float* xx = sums.xx.data();
  float* xw = sums.xw.data();
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
  for (std::size_t c = 0; c < columns; ++c) {
    const float t = sample_weight[c];
    const float sum = weight[c] + t;
    const float r = t / sum, g = weight[c] * r;
    const float dx = place - x[c], dw = sample[c] - w[c];
    weight[c] = sum;
    x[c] += r * dx;
    w[c] += r * dw;
    xx[c] += g * dx * dx;
    xw[c] += g * dx * dw;
  }
}

struct Weighed {
  std::vector<float> w, weight;

  explicit Weighed(const BenchFrame& frame) : w(frame.data.depth.data.size()), weight(w.size()) {
    weigh(frame.data.depth.data, frame.sensor, w, weight);
  }
};

}  // namespace

void readAndWrite(benchmark::State& state, const FrameOf& frame) {
  const std::vector<float>& depth = frame().data.depth.data;
  std::vector<std::int32_t> labels(depth.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < depth.size(); ++i) labels[i] = depth[i] > 0.0f ? 1 : 0;
    benchmark::DoNotOptimize(labels.data());
    benchmark::ClobberMemory();
  }
}

void inverseDepthsAndWeights(benchmark::State& state, const FrameOf& frame) {
  Weighed image(frame());
  for (auto _ : state) {
    weigh(frame().data.depth.data, frame().sensor, image.w, image.weight);
    benchmark::DoNotOptimize(image.weight.data());
    benchmark::ClobberMemory();
  }
}

void lineStatistics(benchmark::State& state, const FrameOf& frame) {
  const Weighed image(frame());
  const auto columns = static_cast<std::size_t>(frame().data.depth.width);
  const auto rows = static_cast<std::size_t>(frame().data.depth.height);
  Statistics sums(columns);
  for (auto _ : state) {
    sums.reset();
    for (std::size_t r = 0; r < rows; ++r)
      addRow(image.w.data() + r * columns, image.weight.data() + r * columns, static_cast<float>(r), columns, sums);
    benchmark::DoNotOptimize(sums.xw.data());
    benchmark::ClobberMemory();
  }
}

}  // namespace epcc::bench
