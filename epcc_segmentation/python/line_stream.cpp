// SPDX-License-Identifier: BSD-3-Clause
// Scan lines as numpy arrays of any stride, checked before their memory is looked at.
#include "line_stream.h"

#include <memory>
#include <string>
#include <utility>

#include "arrays.h"
#include "errors.h"

namespace py = pybind11;

namespace epcc::python {

namespace {

using Kind = StreamGeometry::Kind;

/// Bytes from a value to the next, in values.
template <typename T>
std::ptrdiff_t strideOf(const py::array& array) {
  constexpr auto kSize = static_cast<py::ssize_t>(sizeof(T));
  const py::ssize_t stride = array.shape(0) > 1 ? array.strides(0) : kSize;
  if (stride % kSize != 0 || reinterpret_cast<std::uintptr_t>(array.data()) % alignof(T) != 0)
    throwStatus(Status::SizeMismatch,
                "the scan line's values are not aligned in memory: pass numpy.ascontiguousarray(values)");
  return stride / kSize;
}

void checkSize(const StreamGeometry& geometry, const py::array& array) {
  if (array.shape(0) == geometry.height()) return;
  throwStatus(Status::SizeMismatch, "a scan line of this stream has " + std::to_string(geometry.height()) +
                                        " samples, not " + std::to_string(array.shape(0)));
}

const char* callsFor(Kind kind) {
  switch (kind) {
    case Kind::CameraColumns:
      return "the columns of a camera: add_column(index, values)";
    case Kind::CameraRows:
      return "the rows of a camera: add_row(index, values)";
    case Kind::Scanner:
      return "the columns of a scanner: add_column(index, values, azimuth) or add_column_at(azimuth, values)";
    case Kind::Points:
      break;
  }
  return "the columns of a cloud: add_points(index, points)";
}

/// As the library would, in the names that the calls have here.
void checkKind(const StreamGeometry& geometry, Kind kind) {
  if (kind == geometry.kind()) return;
  throwStatus(Status::UnsupportedScan, std::string("the stream takes ") + callsFor(geometry.kind()));
}

}  // namespace

LineStream::LineStream(const StreamGeometry& geometry, const StreamOptions& options)
    : geometry_(geometry), stream_(geometry, options) {
  if (stream_.status() != Status::Ok) throwStatus(stream_.status(), stream_.error());
  stream_.onPlane([this](const StreamPlane& plane) {
    if (!on_plane.is_none()) handed_out_.emplace_back(plane);
  });
  stream_.onLine([this](const LabelledLine& line) {
    if (!on_line.is_none())
      handed_out_.emplace_back(OwnedLine{line.index, line.azimuth, geometry_.height(), {line.begin(), line.end()}});
  });
}

/// add(values, stride, scale...) as the library takes them.
template <typename Add>
bool LineStream::addValues(Kind kind, const py::array& values, std::optional<double> depth_scale, const Add& add) {
  refuseMasked(values);
  if (values.ndim() != 1)
    throwStatus(Status::SizeMismatch, "the values of a scan line are a row of numbers, not " + shapeText(values));
  checkKind(geometry_, kind);
  checkSize(geometry_, values);
  if (py::isinstance<py::array_t<std::uint16_t>>(values))
    return taken(add(static_cast<const std::uint16_t*>(values.data()), strideOf<std::uint16_t>(values),
                     depth_scale.value_or(DepthView<std::uint16_t>().scale)));
  if (py::isinstance<py::array_t<float>>(values))
    return taken(add(static_cast<const float*>(values.data()), strideOf<float>(values),
                     depth_scale.value_or(DepthView<float>().scale)));
  throwTypeError("the values of a scan line are uint16 or float32, not " + typeText(values));
}

bool LineStream::addColumn(std::int64_t index, const py::array& values, std::optional<double> azimuth,
                           std::optional<double> depth_scale) {
  if (azimuth)
    return addValues(Kind::Scanner, values, depth_scale, [&](const auto* first, std::ptrdiff_t stride, double scale) {
      return stream_.addColumn(index, *azimuth, first, stride, scale);
    });
  return addValues(Kind::CameraColumns, values, depth_scale,
                   [&](const auto* first, std::ptrdiff_t stride, double scale) {
                     return stream_.addColumn(index, first, stride, scale);
                   });
}

bool LineStream::addRow(std::int64_t index, const py::array& values, std::optional<double> depth_scale) {
  return addValues(Kind::CameraRows, values, depth_scale, [&](const auto* first, std::ptrdiff_t stride, double scale) {
    return stream_.addRow(index, first, stride, scale);
  });
}

bool LineStream::addColumnAt(double azimuth, const py::array& values, std::optional<double> depth_scale) {
  return addValues(Kind::Scanner, values, depth_scale, [&](const auto* first, std::ptrdiff_t stride, double scale) {
    return stream_.addColumnAt(azimuth, first, stride, scale);
  });
}

bool LineStream::addPoints(std::int64_t index, const py::array& points) {
  refuseMasked(points);
  if (points.ndim() != 2 || points.shape(1) != 3)
    throwStatus(Status::SizeMismatch, "the points of a scan line are N x 3, not " + shapeText(points));
  if (!py::isinstance<py::array_t<float>>(points)) throwTypeError("points are float32, not " + typeText(points));
  checkKind(geometry_, Kind::Points);
  checkSize(geometry_, points);
  const std::ptrdiff_t stride = points.shape(0) > 1 ? strideOf<float>(points) : 3;
  if (points.strides(1) != static_cast<py::ssize_t>(sizeof(float)) || stride < 3)
    throwStatus(Status::SizeMismatch,
                "the points do not follow one another in memory: pass numpy.ascontiguousarray(points)");
  return taken(stream_.addPoints(index, static_cast<const float*>(points.data()), stride));
}

void LineStream::finish() {
  taken(stream_.finish());
}

void LineStream::reset() {
  handed_out_.clear();
  stream_.reset();
}

std::vector<StreamPlane> LineStream::openPlanes() const {
  std::vector<StreamPlane> planes;
  stream_.openPlanes(planes);
  return planes;
}

bool LineStream::taken(bool was_taken) {
  if (!was_taken && stream_.status() != Status::OutOfOrder) throwStatus(stream_.status(), stream_.error());
  handOut();
  return was_taken;
}

// Taken out first: if what is called throws, the rest comes with the next call. It may add scan lines too, and other
// threads may meanwhile: what comes of these is handed out here, in order.
void LineStream::handOut() {
  if (is_handing_out_) return;
  is_handing_out_ = true;
  const std::unique_ptr<bool, void (*)(bool*)> at_the_end(&is_handing_out_, [](bool* flag) { *flag = false; });
  while (!handed_out_.empty()) {
    const auto next = std::move(handed_out_.front());
    handed_out_.pop_front();
    const bool is_plane = std::holds_alternative<StreamPlane>(next);
    const py::object callback = is_plane ? on_plane : on_line;
    if (callback.is_none()) continue;
    if (is_plane)
      callback(std::get<StreamPlane>(next));
    else
      callback(std::get<OwnedLine>(next));
  }
}

}  // namespace epcc::python
