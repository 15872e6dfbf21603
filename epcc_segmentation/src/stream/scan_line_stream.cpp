// SPDX-License-Identifier: BSD-3-Clause
// Scan lines in, finished planes out: what a caller gives is checked and passed on.
#include "epcc_segmentation/scan_line_stream.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "epcc_segmentation/depth_view.h"
#include "stream/stream_state.h"

namespace epcc {

namespace {

using Kind = StreamGeometry::Kind;

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

bool ScanLineStream::addColumn(std::int64_t index, const float* depth, std::ptrdiff_t stride, double scale) {
  return addScaled(Kind::CameraColumns, index, 0.0, depth, stride, scale);
}

bool ScanLineStream::addRow(std::int64_t index, const float* depth, std::ptrdiff_t stride, double scale) {
  return addScaled(Kind::CameraRows, index, 0.0, depth, stride, scale);
}

bool ScanLineStream::addColumn(std::int64_t index, double azimuth, const float* ranges, std::ptrdiff_t stride,
                               double scale) {
  return addScaled(Kind::Scanner, index, azimuth, ranges, stride, scale);
}

bool ScanLineStream::addColumnAt(double azimuth, const float* ranges, std::ptrdiff_t stride, double scale) {
  return addScaled(Kind::Scanner, indexAt(azimuth), azimuth, ranges, stride, scale);
}

bool ScanLineStream::addColumn(std::int64_t index, const std::uint16_t* depth, std::ptrdiff_t stride, double scale) {
  return addScaled(Kind::CameraColumns, index, 0.0, depth, stride, scale);
}

bool ScanLineStream::addRow(std::int64_t index, const std::uint16_t* depth, std::ptrdiff_t stride, double scale) {
  return addScaled(Kind::CameraRows, index, 0.0, depth, stride, scale);
}

bool ScanLineStream::addColumn(std::int64_t index, double azimuth, const std::uint16_t* ranges, std::ptrdiff_t stride,
                               double scale) {
  return addScaled(Kind::Scanner, index, azimuth, ranges, stride, scale);
}

bool ScanLineStream::addColumnAt(double azimuth, const std::uint16_t* ranges, std::ptrdiff_t stride, double scale) {
  return addScaled(Kind::Scanner, indexAt(azimuth), azimuth, ranges, stride, scale);
}

bool ScanLineStream::addPoints(std::int64_t index, const float* xyz, std::ptrdiff_t stride) {
  if (!accepts(Kind::Points, 0.0, xyz)) return false;
  if (stride < 3) return fail(Status::SizeMismatch, "the points are less than three floats apart");
  return add(index, 0.0, xyz, stride);
}

std::int64_t ScanLineStream::indexAt(double azimuth) const {
  return std::isfinite(azimuth) ? state_->order.indexAt(azimuth) : 0;
}

bool ScanLineStream::accepts(StreamGeometry::Kind kind, double azimuth, const void* values) {
  const State& state = *state_;
  if (!state.isUsable()) return false;
  if (kind != state.geometry.kind())
    return fail(Status::UnsupportedScan, std::string("the stream takes ") + nameOf(state.geometry.kind()));
  if (values == nullptr) return fail(Status::EmptyCloud, "the scan line has no values");
  if (!std::isfinite(azimuth)) return fail(Status::InvalidParameters, "the azimuth must be finite");
  return true;
}

template <typename T>
bool ScanLineStream::addScaled(StreamGeometry::Kind kind, std::int64_t index, double azimuth, const T* values,
                               std::ptrdiff_t stride, double scale) {
  if (!accepts(kind, azimuth, values)) return false;
  if (!(scale > 0.0 && scale <= kMaxDepthScale))
    return fail(Status::InvalidCamera, "the scan line's scale must be positive, at most 1000 m a unit");
  if constexpr (std::is_same<T, float>::value)
    if (scale == 1.0) return add(index, azimuth, values, stride);
  return add(index, azimuth, state_->inMetres(values, stride, scale), 1);
}

bool ScanLineStream::add(std::int64_t index, double azimuth, const float* values, std::ptrdiff_t stride) {
  State& state = *state_;
  return guarded([&] {
    const std::string order_problem = state.orderProblem(index, state.status);
    if (!order_problem.empty()) {
      state.refused += state.status == Status::OutOfOrder ? 1 : 0;
      state.error = order_problem;
      return false;
    }
    // A count that is full stays so: indices that jump far may come again and again.
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
    state.lost += std::min(state.order.lostBefore(index), kMost - state.lost);
    ++state.taken;
    state.order.take(index, azimuth);
    state.receive({index, azimuth, values, stride});
    return true;
  });
}

bool ScanLineStream::finish() {
  State& state = *state_;
  if (!state.isUsable()) return false;
  return guarded([&] {
    state.finish();
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

Status ScanLineStream::status() const noexcept {
  return state_->status;
}

const std::string& ScanLineStream::error() const noexcept {
  return state_->error;
}

std::int64_t ScanLineStream::taken() const noexcept {
  return state_->taken;
}

std::int64_t ScanLineStream::lost() const noexcept {
  return state_->lost;
}

std::int64_t ScanLineStream::refused() const noexcept {
  return state_->refused;
}

const SensorModel& ScanLineStream::sensor() const noexcept {
  return state_->sensor;
}

bool ScanLineStream::isMeasuring() const noexcept {
  return state_->is_measuring;
}

std::size_t ScanLineStream::measuredBlocks() const noexcept {
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
