// SPDX-License-Identifier: BSD-3-Clause
// Scan lines in, finished planes out: checks, Algorithm 1 on what was collected, Algorithm 2 line by line.
#include "epcc_segmentation/scan_line_stream.h"

#include <array>
#include <cmath>
#include <exception>
#include <new>
#include <utility>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "epcc_segmentation/vector_unit.h"
#include "metric/strip_lines.h"
#include "stream/collected_strip.h"
#include "stream/line_order.h"
#include "stream/measured_stretch.h"
#include "stream/segment_sums.h"
#include "stream/stream_planes.h"

namespace epcc {

namespace {

using Kind = StreamGeometry::Kind;

constexpr std::int64_t kLongestPlane = 10000000;
constexpr std::int64_t kLargestIndex = std::int64_t{1} << 62;
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

const char* nameOf(Kind kind) {
  switch (kind) {
    case Kind::CameraColumns:
      return "the columns of a camera: addColumn(index, depth)";
    case Kind::CameraRows:
      return "the rows of a camera: addRow(index, depth)";
    case Kind::Scanner:
      return "the columns of a scanner: addColumn(index, azimuth, ranges) or addColumnAt(azimuth, ranges)";
    case Kind::Points:
      break;
  }
  return "the columns of a cloud: addPoints(index, xyz)";
}

}  // namespace

struct ScanLineStream::State {
  State(const StreamGeometry& given_geometry, const StreamOptions& given_options);
  void begin();
  std::string orderProblem(std::int64_t index, Status& why) const;
  /// Otherwise status and error say why, or said so.
  bool isUsable() const { return problem.empty() && !is_broken; }
  void take(const GivenLine& line);
  void collect(const GivenLine& line);
  void measureSensor();
  void useSensor(const SensorModel& model);
  void cluster();

  StreamGeometry geometry;
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

ScanLineStream::State::State(const StreamGeometry& given_geometry, const StreamOptions& given_options)
    : geometry(given_geometry),
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
  collected.begin(geometry);
  has_collected = false;
  numbers.assign(static_cast<std::size_t>(geometry.height()) * kStripLines, 0);
  measured_blocks = 0;
  is_measuring = !options.sensor.has_value();
  stretch.begin(geometry, options.measured_lines);
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
  switch (geometry.kind()) {
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

ScanLineStream::ScanLineStream(const StreamGeometry& geometry, const StreamOptions& options)
    : state_(std::make_unique<State>(geometry, options)) {}
ScanLineStream::~ScanLineStream() = default;
ScanLineStream::ScanLineStream(ScanLineStream&&) noexcept = default;
ScanLineStream& ScanLineStream::operator=(ScanLineStream&&) noexcept = default;

void ScanLineStream::onPlane(std::function<void(const StreamPlane&)> callback) {
  state_->planes.on_plane = std::move(callback);
}

void ScanLineStream::onLine(std::function<void(const LabelledLine&)> callback) {
  state_->planes.on_line = std::move(callback);
}

bool ScanLineStream::addColumn(std::int64_t index, const float* depth, std::ptrdiff_t stride) {
  return add(Kind::CameraColumns, index, 0.0, depth, stride);
}

bool ScanLineStream::addRow(std::int64_t index, const float* depth, std::ptrdiff_t stride) {
  return add(Kind::CameraRows, index, 0.0, depth, stride);
}

bool ScanLineStream::addColumn(std::int64_t index, double azimuth, const float* ranges, std::ptrdiff_t stride) {
  return add(Kind::Scanner, index, azimuth, ranges, stride);
}

bool ScanLineStream::addColumnAt(double azimuth, const float* ranges, std::ptrdiff_t stride) {
  const std::int64_t index = std::isfinite(azimuth) ? state_->order.indexAt(azimuth) : 0;
  return add(Kind::Scanner, index, azimuth, ranges, stride);
}

bool ScanLineStream::addPoints(std::int64_t index, const float* xyz, std::ptrdiff_t stride) {
  if (stride < 3) return fail(Status::SizeMismatch, "the points are less than three floats apart");
  return add(Kind::Points, index, 0.0, xyz, stride);
}

bool ScanLineStream::add(StreamGeometry::Kind kind, std::int64_t index, double azimuth, const float* values,
                         std::ptrdiff_t stride) {
  State& state = *state_;
  if (!state.isUsable()) return false;
  if (kind != state.geometry.kind())
    return fail(Status::UnsupportedScan, std::string("the stream takes ") + nameOf(state.geometry.kind()));
  if (values == nullptr) return fail(Status::EmptyCloud, "the scan line has no values");
  if (!std::isfinite(azimuth)) return fail(Status::InvalidParameters, "the azimuth must be finite");
  return guarded([&] {
    const std::string order_problem = state.orderProblem(index, state.status);
    if (!order_problem.empty()) {
      state.refused += state.status == Status::OutOfOrder ? 1 : 0;
      state.error = order_problem;
      return false;
    }
    state.lost += state.order.lostBefore(index);
    ++state.taken;
    state.order.take(index, azimuth);
    state.take({index, azimuth, values, stride});
    return true;
  });
}

bool ScanLineStream::finish() {
  State& state = *state_;
  if (!state.isUsable()) return false;
  return guarded([&] {
    if (state.is_measuring && state.stretch.size() > 0) state.measureSensor();
    state.cluster();
    state.planes.finish();
    state.order.begin(state.geometry.azimuthStep());
    state.has_collected = false;
    return true;
  });
}

void ScanLineStream::reset() {
  State& state = *state_;
  if (!state.problem.empty()) return;
  guarded([&] {
    state.begin();
    return true;
  });
}

void ScanLineStream::openPlanes(std::vector<StreamPlane>& planes) const {
  state_->planes.listOpen(planes);
}

Status ScanLineStream::status() const {
  return state_->status;
}

const std::string& ScanLineStream::error() const {
  return state_->error;
}

std::int64_t ScanLineStream::taken() const {
  return state_->taken;
}

std::int64_t ScanLineStream::lost() const {
  return state_->lost;
}

std::int64_t ScanLineStream::refused() const {
  return state_->refused;
}

const SensorModel& ScanLineStream::sensor() const {
  return state_->sensor;
}

bool ScanLineStream::isMeasuring() const {
  return state_->is_measuring;
}

std::size_t ScanLineStream::measuredBlocks() const {
  return state_->measured_blocks;
}

bool ScanLineStream::fail(Status status, const std::string& error) {
  state_->status = status;
  state_->error = error;
  return false;
}

/// What is thrown leaves the stream in between: it stays so until reset().
template <typename Work>
bool ScanLineStream::guarded(const Work& work) {
  state_->status = Status::Ok;
  state_->error.clear();
  state_->is_broken = true;
  try {
    const bool done = work();
    state_->is_broken = false;
    return done;
  } catch (const std::bad_alloc&) {
    return fail(Status::OutOfMemory, "out of memory");  // short enough to need none
  } catch (const std::exception& error) {
    return fail(Status::Failed, error.what());
  }
}

}  // namespace epcc
