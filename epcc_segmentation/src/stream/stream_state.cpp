// SPDX-License-Identifier: BSD-3-Clause
// Lines are collected, Algorithm 1 runs on what was collected, Algorithm 2 line by line.
#include "stream/stream_state.h"

#include <string>

#include "depth_rows.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "epcc_segmentation/vector_unit.h"

namespace epcc {

namespace {

using Kind = StreamGeometry::Kind;

constexpr std::int64_t kLongestPlane = 10000000;
constexpr std::int64_t kLargestIndex = (std::int64_t{1} << 62) - 1;  // two of them differ by a number that there is
constexpr std::int64_t kLargestOfCamera = 1000000;

std::string optionsProblem(const StreamOptions& options) {
  Parameters parameters;
  parameters.paper = options.paper;
  std::string problem = parameters.validate();
  if (problem.empty() && options.sensor.has_value()) problem = options.sensor->validate();
  if (!problem.empty()) return problem;
  if (options.measured_lines < 32 || options.measured_lines > 4096)
    return "measured_lines must be in [32, 4096], not " + std::to_string(options.measured_lines);
  if (options.lines_at_once < 1 || options.lines_at_once > kStripLines)
    return "lines_at_once must be in [1, 32], not " + std::to_string(options.lines_at_once);
  if (options.longest_plane < 0 || options.longest_plane > kLongestPlane)
    return "longest_plane must be in [0, 10000000], not " + std::to_string(options.longest_plane);
  return vectorUnitProblem();
}

/// As many values as `memory` has: where they lie, or in it.
template <typename T>
const T* sideBySide(const T* values, std::ptrdiff_t stride, std::vector<T>& memory) {
  if (stride == 1) return values;
  for (std::size_t i = 0; i < memory.size(); ++i) memory[i] = values[static_cast<std::ptrdiff_t>(i) * stride];
  return memory.data();
}

StreamGeometry lineGeometry(const StreamGeometry& geometry) {
  if (!geometry.isStaggered()) return geometry;
  return StreamGeometry::points(geometry.height(), geometry.projection(), geometry.azimuthStep());
}

}  // namespace

ScanLineStream::State::State(const StreamGeometry& given_geometry, const StreamOptions& given_options)
    : geometry(given_geometry),
      line_geometry(lineGeometry(given_geometry)),
      options(given_options),
      sensor(options.sensor.value_or(SensorEstimate().model())),
      problem(geometry.validate()) {
  if (!problem.empty()) {
    status = geometry.kind() < Kind::Scanner ? Status::InvalidCamera : Status::InvalidParameters;
  } else {
    problem = optionsProblem(options);
    if (!problem.empty()) status = Status::InvalidParameters;
  }
  error = problem;
  if (problem.empty()) begin();
}

void ScanLineStream::State::begin() {
  is_broken = false;
  taken = lost = refused = 0;
  order.begin(geometry.azimuthStep());
  units.assign(static_cast<std::size_t>(geometry.height()), 0);
  metres.assign(static_cast<std::size_t>(geometry.height()), 0.0f);
  rings.begin(geometry);
  collected.begin(line_geometry);
  has_collected = false;
  numbers.assign(static_cast<std::size_t>(geometry.height()) * kStripLines, 0);
  measured_blocks = 0;
  is_measuring = !options.sensor.has_value();
  stretch.begin(line_geometry, options.measured_lines);
  useSensor(options.sensor.value_or(SensorEstimate().model()));
}

void ScanLineStream::State::useSensor(const SensorModel& model) {
  sensor = model;
  rule = ClusteringRule(options.paper, sensor);
  sums.begin(geometry.height(), sensor);
  std::int64_t longest = options.longest_plane;
  if (longest == 0) longest = geometry.columnsOfTurn() > 0 ? geometry.columnsOfTurn() : kLongestPlane;
  planes.begin(options.paper, sensor, geometry.projection(), longest, collected.axes());
}

std::string ScanLineStream::State::orderProblem(std::int64_t index, Status& why) const {
  const std::string name = geometry.kind() == Kind::CameraRows ? "row " : "column ";
  why = Status::SizeMismatch;
  const int count = geometry.lineCount();
  const std::int64_t largest = count > 0 ? count - 1 : kLargestOfCamera;
  if (geometry.kind() < Kind::Scanner && (index < 0 || index > largest))
    return name + std::to_string(index) + " is not one of 0 to " + std::to_string(largest);
  if (index < -kLargestIndex || index > kLargestIndex) return name + "indices must be within 2^62";
  why = Status::OutOfOrder;
  const std::int64_t between = order.lostBefore(index);
  if (between == -1) return name + std::to_string(index) + " came twice";
  if (between < 0) return name + std::to_string(index) + " came late, after " + name + std::to_string(order.last());
  why = Status::Ok;
  return {};
}

const float* ScanLineStream::State::inMetres(const std::uint16_t* values, std::ptrdiff_t stride, double scale) {
  depthsInMetres(sideBySide(values, stride, units), metres.size(), scale, metres.data());
  return metres.data();
}

const float* ScanLineStream::State::inMetres(const float* values, std::ptrdiff_t stride, double scale) {
  depthsInMetres(sideBySide(values, stride, metres), metres.size(), scale, metres.data());
  return metres.data();
}

void ScanLineStream::State::receive(const GivenLine& line) {
  if (!geometry.isStaggered()) return take(line);
  rings.add(line, [this](const GivenLine& complete) { take(complete); });
}

void ScanLineStream::State::finish() {
  rings.finish([this](const GivenLine& complete) { take(complete); });
  if (is_measuring && stretch.size() > 0) measureSensor();
  cluster();
  planes.finish();
  order.begin(geometry.azimuthStep());
  has_collected = false;
}

void ScanLineStream::State::take(const GivenLine& line) {
  if (is_measuring && !stretch.takes(line.index)) measureSensor();
  if (is_measuring)
    stretch.add(line);
  else
    collect(line);
}

void ScanLineStream::State::measureSensor() {
  const SensorEstimate estimate = stretch.measure();
  measured_blocks = estimate.blocks;
  useSensor(estimate.model());
  is_measuring = false;
  for (std::size_t i = 0; i < stretch.size(); ++i) collect(stretch.line(i));
  stretch.clear();
}

void ScanLineStream::State::collect(const GivenLine& line) {
  const std::int64_t lost_before = has_collected ? line.index - last_collected - 1 : 0;
  places[static_cast<std::size_t>(collected.size())] = {line.index, lost_before, line.azimuth};
  last_collected = line.index;
  has_collected = true;
  switch (line_geometry.kind()) {
    case Kind::CameraColumns:
    case Kind::CameraRows:
      collected.addDepths(line.index, line.values, line.stride);
      break;
    case Kind::Scanner:
      collected.addRanges(line.azimuth, line.values, line.stride);
      break;
    case Kind::Points:
      collected.addPoints(line.values, line.stride);
      break;
  }
  if (collected.size() == options.lines_at_once) cluster();
}

/// The paper's two algorithms on the collected lines.
void ScanLineStream::State::cluster() {
  if (collected.size() == 0) return;
  const SegmentNumbers all_numbers{1, kStripLines, numbers.data(), kStripLines};
  strip_lines.cluster(collected.strip(), rule, all_numbers, collected.size());  // Algorithm 1
  for (int i = 0; i < collected.size(); ++i) {
    const Place& place = places[static_cast<std::size_t>(i)];
    if (place.lost_before > 0) planes.skipLines(place.lost_before);
    strip_lines.list(i, collected.direction(i, strip_lines.directionSum(i)), segments);
    PendingLine& line = planes.nextLine();
    line.index = place.index;
    line.azimuth = place.azimuth;
    sums.sum(collected.row(i), numbers.data() + i, strip_lines.count(i), line);
    planes.addLine(segments);  // Algorithm 2
  }
  collected.clear();
}

}  // namespace epcc
