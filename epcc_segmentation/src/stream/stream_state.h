// SPDX-License-Identifier: BSD-3-Clause
// What a stream of scan lines keeps between two of them, and what it does with one that came in order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "epcc_segmentation/scan_line_stream.h"
#include "metric/strip_lines.h"
#include "stream/collected_strip.h"
#include "stream/line_order.h"
#include "stream/measured_stretch.h"
#include "stream/segment_sums.h"
#include "stream/staggered_rings.h"
#include "stream/stream_planes.h"

namespace epcc {

struct ScanLineStream::State {
  State(const StreamGeometry& given_geometry, const StreamOptions& given_options);
  void begin();
  std::string orderProblem(std::int64_t index, Status& why) const;
  /// Otherwise status and error say why, or said so.
  bool isUsable() const { return problem.empty() && !is_broken; }
  /// Values of a scan line in metres, as DepthFrame reads those of an image: valid until the next call.
  const float* inMetres(const std::uint16_t* values, std::ptrdiff_t stride, double scale);
  const float* inMetres(const float* values, std::ptrdiff_t stride, double scale);
  /// A scan line, or a column whose rings belong to several.
  void receive(const GivenLine& line);
  void take(const GivenLine& line);
  void collect(const GivenLine& line);
  void finish();
  void measureSensor();
  void useSensor(const SensorModel& model);
  void cluster();

  StreamGeometry geometry;
  StreamGeometry line_geometry;  // of the scan lines that Algorithm 1 sees: staggered rings come as points
  StreamOptions options;
  SensorModel sensor;
  Status status = Status::Ok;
  std::string error;
  std::string problem;  // of geometry and options
  bool is_broken = false;
  bool is_measuring = false;
  std::size_t measured_blocks = 0;
  std::int64_t taken = 0, lost = 0, refused = 0;
  LineOrder order;
  std::vector<std::uint16_t> units;  // of a scan line with a scale: side by side ...
  std::vector<float> metres;         // ... and what they are
  StaggeredRings rings;
  MeasuredStretch stretch;
  CollectedStrip collected;
  struct Place {
    std::int64_t index, lost_before;
    double azimuth;
  };
  std::array<Place, kStripLines> places{};  // of the collected lines
  std::int64_t last_collected = 0;
  bool has_collected = false;
  ClusteringRule rule;
  StripLines strip_lines;
  std::vector<std::int32_t> numbers;
  std::vector<ClusteredLine> segments;
  SegmentSums sums;
  StreamPlanes planes;
};

}  // namespace epcc
