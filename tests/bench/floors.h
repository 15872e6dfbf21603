// SPDX-License-Identifier: BSD-3-Clause
// What no method can go below: passes over a frame that do a part of the work and nothing else.
#pragma once

#include <benchmark/benchmark.h>

#include "tests/bench/bench_frames.h"

namespace epcc::bench {

/// Every depth read, one label written a pixel.
void readAndWrite(benchmark::State& state, const FrameOf& frame);
/// Every depth -> inverse depth and the weight of it.
void inverseDepthsAndWeights(benchmark::State& state, const FrameOf& frame);
/// S1's recursive sums down the columns of the inverse depths, as if no sample was ever rejected.
void lineStatistics(benchmark::State& state, const FrameOf& frame);

}  // namespace epcc::bench
