// SPDX-License-Identifier: BSD-3-Clause
// What is timed of a frame: the extractor in its modes, the PCL class, the methods of the comparison.
#pragma once

#include <benchmark/benchmark.h>

#include <string>

#include "epcc_segmentation/parameters.h"
#include "tests/bench/bench_frames.h"

namespace epcc::bench {

/// How the extractor is used.
struct Extraction {
  enum class Sensor {
    Given,    ///< the frame's own model
    Single,   ///< measured on each frame as if it was the first
    Settled,  ///< measured on a stream that has settled
  };
  Parameters parameters;
  Sensor sensor = Sensor::Given;
  bool units = false;       ///< 16-bit depths
  std::string vector_unit;  ///< empty: the one in use
};

/// A whole frame; the stages' mean milliseconds and the number of planes are the counters.
void extraction(benchmark::State& state, const FrameOf& frame, const Extraction& how);
/// The sensor measured in the frame, and nothing else.
void sensorEstimation(benchmark::State& state, const FrameOf& frame);
/// A method of the comparison with all it does to the frame. Counters, ms: the method itself, the conversion to a PCL
/// cloud, the least-squares planes of the result.
void comparedMethod(benchmark::State& state, const FrameOf& frame, const std::string& method);
/// EPCCSegmentation<pcl::PointXYZ>: an organized cloud in; coefficients, inliers, centroids and labels out.
void pclClass(benchmark::State& state, const FrameOf& frame);
/// The same with pcl::PointXYZRGB, whose points take twice the memory.
void pclClassWithColours(benchmark::State& state, const FrameOf& frame);

}  // namespace epcc::bench
