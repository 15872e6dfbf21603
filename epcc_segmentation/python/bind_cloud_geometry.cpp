// SPDX-License-Identifier: BSD-3-Clause
// How an organized cloud was measured: epcc.CloudOptions, CloudGeometry, GeometryFinder and find_geometry().
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "errors.h"
#include "frames.h"
#include "words.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

using SharedGeometry = std::shared_ptr<CloudGeometry>;

void setSensor(CloudOptions& options, const std::string& word) {
  const auto sensor = sensorKindOf(word);
  if (!sensor) throw py::value_error("'" + word + "' is none of 'any', 'camera', 'scanner'");
  options.sensor = *sensor;
}

void setProjection(CloudOptions& options, const std::optional<std::string>& word) {
  options.projection = std::nullopt;
  if (!word) return;
  options.projection = projectionOf(*word);
  if (!options.projection)
    throw py::value_error("'" + *word + "' is none of 'perspective', 'perspective-backward', 'spherical'");
}

std::optional<std::string> projectionText(const CloudOptions& options) {
  return options.projection ? std::optional<std::string>(projectionWord(*options.projection)) : std::nullopt;
}

CloudOptions options(const std::string& sensor, const std::optional<std::string>& projection, double unit,
                     double min_depth, double max_depth, std::optional<float> invalid,
                     const std::optional<SensorPose>& viewpoint) {
  CloudOptions options;
  setSensor(options, sensor);
  setProjection(options, projection);
  options.unit = unit;
  options.min_depth = min_depth;
  options.max_depth = max_depth;
  options.invalid = invalid;
  options.viewpoint = viewpoint;
  throwProblem(Status::InvalidParameters, options.validate());
  return options;
}

py::array invalidPoints(const CloudGeometry& geometry) {
  py::array_t<float> points({static_cast<py::ssize_t>(geometry.invalid_points.size()), static_cast<py::ssize_t>(3)});
  float* next = points.mutable_data();
  for (const Vector3f& point : geometry.invalid_points)
    for (int i = 0; i < 3; ++i) *next++ = point(i);
  return readOnly(std::move(points));
}

std::string text(const CloudGeometry& g) {
  return py::str("<epcc.CloudGeometry {}, {} m a unit, residual {:.4f}{}>")
      .format(projectionWord(g.projection), g.unit, g.residual, g.is_plain ? "" : ", posed");
}

void bindPose(py::module_& module) {
  py::class_<SensorPose>(module, "SensorPose",
                         "Where a sensor is: p = axes @ s + origin for a point s of its own frame.")
      .def(py::init([](const Matrix3& axes, const Vector3& origin) {
             return SensorPose{axes, origin};
           }),
           "axes"_a, "origin"_a)
      .def_readonly("axes", &SensorPose::axes,
                    "3 x 3, columns: the sensor's axes in the cloud's frame; orthogonal, maybe mirrored.")
      .def_readonly("origin", &SensorPose::origin, "3: its place in the cloud's frame, metres.");
}

void bindOptions(py::module_& module) {
  py::class_<CloudOptions>(module, "CloudOptions", R"(What is known of a cloud; nothing of it need be said.

sensor: "any", "camera" or "scanner".
projection: the cloud is in the frame that this projection has, nothing is searched: "perspective" (x right, y down,
  z forward), "perspective-backward" (x right, y up, z back) or "spherical" (x forward, y left, z up).
unit: metres per unit of the coordinates; 0: 1, or 0.001 where metres are impossible.
min_depth, max_depth: nearer or farther points are invalid: depth of a camera, range of a scanner; metres.
invalid: a point all of whose coordinates are this is none, as is NaN.
viewpoint: where the sensor may have been, in units of the cloud: tried like other poses.
InputError for values out of range.)")
      .def(py::init(&options), py::kw_only(), "sensor"_a = "any", "projection"_a = py::none(), "unit"_a = 0.0,
           "min_depth"_a = 0.0, "max_depth"_a = std::numeric_limits<double>::infinity(), "invalid"_a = py::none(),
           "viewpoint"_a = py::none())
      .def_property(
          "sensor", [](const CloudOptions& o) { return sensorWord(o.sensor); }, &setSensor,
          "\"any\", \"camera\" or \"scanner\".")
      .def_property("projection", &projectionText, &setProjection, "The cloud's frame, where it is known; else None.")
      .def_readwrite("unit", &CloudOptions::unit, "Metres per unit; 0: guessed.")
      .def_readwrite("min_depth", &CloudOptions::min_depth, "Nearer points are invalid, metres.")
      .def_readwrite("max_depth", &CloudOptions::max_depth, "Farther points are invalid, metres.")
      .def_readwrite("invalid", &CloudOptions::invalid, "Coordinates of a point that is none.")
      .def_readwrite("viewpoint", &CloudOptions::viewpoint, "SensorPose to try, or None.");
}

void bindGeometry(py::module_& module) {
  py::class_<ScanGrid>(module, "ScanGrid", "The rings of a scanner in the cloud.")
      .def_readonly("rings_are_columns", &ScanGrid::rings_are_columns, "True if a ring is a column of the cloud.")
      .def_readonly("ring_order", &ScanGrid::ring_order, "The cloud's ring of each ring; empty: as in the cloud.")
      .def_readonly("ring_shift", &ScanGrid::ring_shift, "Columns by which a ring lags in the cloud; empty: none.")
      .def_readonly("margin", &ScanGrid::margin, "Columns that the scan has more than the cloud.")
      .def_readonly("closes_round", &ScanGrid::closes_round, "The last column adjoins the first.");
  py::class_<CloudGeometry, SharedGeometry>(module, "CloudGeometry",
                                            "How a cloud was measured, as find_geometry() found it.")
      .def_readonly("is_plain", &CloudGeometry::is_plain,
                    "Frame, unit and order of pixels are the projection's own: nothing need be converted.")
      .def_property_readonly(
          "projection", [](const CloudGeometry& g) { return projectionWord(g.projection); },
          "Of the sensor's own frame: \"perspective\", \"perspective-backward\" or \"spherical\".")
      .def_readonly("pose", &CloudGeometry::pose, "SensorPose in the cloud's frame, metres.")
      .def_readonly("unit", &CloudGeometry::unit, "Metres per unit of the coordinates.")
      .def_readonly("unit_is_guessed", &CloudGeometry::unit_is_guessed, "Nobody said that it is not the metre.")
      .def_readonly("grid", &CloudGeometry::grid, "ScanGrid of a scanner.")
      .def_readonly("residual", &CloudGeometry::residual,
                    "How far points are off their pixels' rays: the 80 % quantile, in deviations of all rays.")
      .def_property_readonly("invalid_points", &invalidPoints,
                             "N x 3 float32: what stands for no point, in units of the cloud.")
      .def_readonly("min_depth", &CloudGeometry::min_depth, "Nearer points are invalid, metres.")
      .def_readonly("max_depth", &CloudGeometry::max_depth, "Farther points are invalid, metres.")
      .def("__repr__", &text);
}

}  // namespace

void bindCloudGeometry(py::module_& module) {
  bindPose(module);
  bindOptions(module);
  bindGeometry(module);
  py::class_<Exclusive<GeometryFinder>>(module, "GeometryFinder", R"(Finds the geometry of clouds of a stream.

Keeps its memory, and tries what it found last before it searches. May be shared between threads, which take turns.)")
      .def(py::init<>())
      .def(
          "find",
          [](Exclusive<GeometryFinder>& finder, const py::array& points, const CloudOptions& options) {
            return foundGeometry(finder, points, options);
          },
          "points"_a, "options"_a = CloudOptions(), "As find_geometry().");
  module.def(
      "find_geometry",
      [](const py::array& points, const CloudOptions& options) {
        Exclusive<GeometryFinder> finder;
        return foundGeometry(finder, points, options);
      },
      "points"_a, "options"_a = CloudOptions(), R"(Finds out how an organized cloud was measured.

points: H x W x 3 float32 in any frame, unit and order of rows and columns. A few hundred points are looked at.
InputError (Status.UNKNOWN_GEOMETRY) if neither a camera nor a scanner sees them so.)");
}

}  // namespace epcc::python
