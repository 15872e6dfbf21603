// SPDX-License-Identifier: BSD-3-Clause
// epcc.ScanLineStream, and the planes and labelled scan lines that it hands out.
#include <pybind11/stl.h>

#include <algorithm>
#include <string>

#include "arrays.h"
#include "bindings.h"
#include "line_stream.h"
#include "sensors.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

void setCallback(py::object& callback, const py::object& function, const char* name) {
  if (!function.is_none() && !PyCallable_Check(function.ptr()))
    throw py::type_error(std::string(name) + " must be a function of one argument, or None");
  callback = function;
}

std::unique_ptr<LineStream> stream(const StreamGeometry& geometry, const std::shared_ptr<Parameters>& parameters,
                                   const py::object& sensor, int measured_lines, int lines_at_once,
                                   std::int64_t longest_plane, const py::object& on_plane, const py::object& on_line) {
  StreamOptions options;
  if (parameters) options.paper = parameters->paper;
  options.sensor = sensorOf(sensor);
  options.measured_lines = measured_lines;
  options.lines_at_once = lines_at_once;
  options.longest_plane = longest_plane;
  auto made = std::make_unique<LineStream>(geometry, options);
  setCallback(made->on_plane, on_plane, "on_plane");
  setCallback(made->on_line, on_line, "on_line");
  return made;
}

/// N x 3: first, last, plane.
py::array runsOf(const OwnedLine& line) {
  py::array_t<std::int64_t> runs({static_cast<py::ssize_t>(line.runs.size()), py::ssize_t{3}});
  std::int64_t* next = runs.mutable_data();
  for (const LabelRun& run : line.runs)
    for (const std::int64_t value : {std::int64_t{run.first}, std::int64_t{run.last}, run.plane}) *next++ = value;
  return readOnly(std::move(runs));
}

/// One a sample, 0 for no plane.
py::array labelsOf(const OwnedLine& line) {
  py::array_t<std::int64_t> labels(line.height);
  std::int64_t* label = labels.mutable_data();
  std::fill_n(label, line.height, 0);
  for (const LabelRun& run : line.runs) std::fill(label + run.first, label + run.last + 1, run.plane);
  return readOnly(std::move(labels));
}

void bindHandedOut(py::module_& module) {
  py::class_<StreamPlane>(module, "StreamPlane", "A plane of a ScanLineStream.")
      .def_readonly("id", &StreamPlane::id, "1, 2, ... in the order in which planes became large enough.")
      .def_readonly("plane", &StreamPlane::plane, "The Plane, in the sensor's frame.")
      .def_readonly("first_line", &StreamPlane::first_line, "Index of the first scan line with a segment of it.")
      .def_readonly("last_line", &StreamPlane::last_line, "Index of the last scan line with a segment of it.")
      .def_readonly("segments", &StreamPlane::segments, "Number of its line segments.")
      .def_readonly("is_cut", &StreamPlane::is_cut, "True if longest_plane was reached: what follows has another id.")
      .def("__repr__", [](const StreamPlane& p) {
        return py::str("<epcc.StreamPlane {}, lines {} to {}, {}>").format(p.id, p.first_line, p.last_line, p.plane);
      });
  py::class_<OwnedLine>(module, "LabelledLine", "The labels of a scan line of a ScanLineStream, final.")
      .def_readonly("index", &OwnedLine::index, "Of the scan line, as it was given or counted.")
      .def_readonly("azimuth", &OwnedLine::azimuth, "As it was given, radians; 0 if none was.")
      .def_property_readonly("runs", &runsOf,
                             "N x 3 int64: first sample, last sample and StreamPlane.id of neighbours with one label.")
      .def_property_readonly("labels", &labelsOf, "Of each sample its StreamPlane.id, 0 for no plane; int64.");
}

bool isConstructed(PyObject* self) {
  return reinterpret_cast<py::detail::instance*>(self)->get_value_and_holder().holder_constructed();
}

/// A stream's functions may hold the stream: Python's collector has to see them.
void collectible(PyHeapTypeObject* heap_type) {
  PyTypeObject* type = &heap_type->ht_type;
  type->tp_flags |= Py_TPFLAGS_HAVE_GC;
  type->tp_traverse = [](PyObject* self, visitproc visit, void* arg) -> int {
#if PY_VERSION_HEX >= 0x03090000
    Py_VISIT(Py_TYPE(self));
#endif
    if (!isConstructed(self)) return 0;
    const auto& stream = py::cast<const LineStream&>(py::handle(self));
    Py_VISIT(stream.on_plane.ptr());
    Py_VISIT(stream.on_line.ptr());
    return 0;
  };
  type->tp_clear = [](PyObject* self) -> int {
    if (!isConstructed(self)) return 0;
    auto& stream = py::cast<LineStream&>(py::handle(self));
    stream.on_plane = py::none();
    stream.on_line = py::none();
    return 0;
  };
}

void bindAdding(py::class_<LineStream>& type) {
  type.def("add_column", &LineStream::addColumn, "index"_a, "values"_a, "azimuth"_a = py::none(), py::kw_only(),
           "depth_scale"_a = py::none(), R"(A column of a camera, or with its azimuth one of a scanner.

index: rises; what is left out counts as lost. Of a scanner it counts the columns of all turns.
values: depths, or of a scanner the ranges of its rings, geometry.height of them with any stride: float32 in metres (<= 0,
  NaN and Inf are not measured) or uint16 in millimetres (0 and 65535 are not measured).
azimuth: of a scanner's column, radians about the z-up axis, 0 forward and growing to the left.
depth_scale: metres per unit, where it is another one.

False, and the column is left out, if it comes late or twice.)")
      .def("add_row", &LineStream::addRow, "index"_a, "values"_a, py::kw_only(), "depth_scale"_a = py::none(),
           "A row of a camera that is read row by row; everything else is as for add_column().")
      .def("add_column_at", &LineStream::addColumnAt, "azimuth"_a, "values"_a, py::kw_only(),
           "depth_scale"_a = py::none(),
           R"(A column of a scanner where nobody counts: its place follows from the azimuth.

A column that lies up to half a turn behind the last one is late: False. The rest is as for add_column().)")
      .def("add_points", &LineStream::addPoints, "index"_a, "points"_a,
           "A column of a cloud: N x 3 float32, metres, in the sensor's frame, NaN where nothing was measured.")
      .def("finish", &LineStream::finish,
           "The stream, or a frame of it, has ended: all that is left comes out. The next line begins anew; ids go on.")
      .def("reset", &LineStream::reset, "Forgets all that is not handed out yet, and begins anew with id 1.")
      .def("open_planes", &LineStream::openPlanes,
           "The StreamPlanes that can grow still and are large enough already, by id.");
}

}  // namespace

void bindScanLineStream(py::module_& module) {
  bindHandedOut(module);
  py::class_<LineStream> type(module, "ScanLineStream", py::custom_type_setup(&collectible),
                              R"(Segments scan lines as they come, in the paper mode: planes as they are finished.

geometry: StreamGeometry, what the scan lines are.
parameters: Parameters, of which the group `paper` counts; None: its defaults.
sensor: as segment(); if it is None or "auto", it is measured on the first measured_lines scan lines, which wait for it.
measured_lines: [32, 4096]. lines_at_once: scan lines that are taken side by side, [1, 32]: fewer come sooner and cost
more. longest_plane: scan lines after which a plane is cut; 0: a turn of a scanner, else ten million.
on_plane: called with each StreamPlane that no coming scan line can add to, behind its lines.
on_line: called with each LabelledLine, in order, as soon as it is certain which of its planes are large enough.

Both are called from within the functions that add lines, and from finish(), when these are done; what they raise comes
out of there, and what they were not told yet is told with the next line. Memory stays bounded. What cannot be used is an
InputError; a line that comes late or twice is none, it is left out and counted as refused.)");
  type.def(py::init(&stream), "geometry"_a, "parameters"_a = py::none(), "sensor"_a = py::none(), py::kw_only(),
           "measured_lines"_a = 512, "lines_at_once"_a = 32, "longest_plane"_a = 0, "on_plane"_a = py::none(),
           "on_line"_a = py::none());
  bindAdding(type);
  type.def_property(
          "on_plane", [](const LineStream& s) { return s.on_plane; },
          [](LineStream& s, const py::object& function) { setCallback(s.on_plane, function, "on_plane"); },
          "Called with each finished StreamPlane; None: nothing is.")
      .def_property(
          "on_line", [](const LineStream& s) { return s.on_line; },
          [](LineStream& s, const py::object& function) { setCallback(s.on_line, function, "on_line"); },
          "Called with each LabelledLine; None: nothing is.")
      .def_property_readonly("geometry", &LineStream::geometry, "The StreamGeometry.")
      .def_property_readonly(
          "taken", [](const LineStream& s) { return s.stream().taken(); }, "Scan lines taken since the beginning.")
      .def_property_readonly(
          "lost", [](const LineStream& s) { return s.stream().lost(); }, "Scan lines whose indices were left out.")
      .def_property_readonly(
          "refused", [](const LineStream& s) { return s.stream().refused(); }, "Scan lines that came late or twice.")
      .def_property_readonly(
          "sensor", [](const LineStream& s) { return s.stream().sensor(); },
          "The SensorModel in use: as given or measured, before that the generic one.")
      .def_property_readonly(
          "is_measuring", [](const LineStream& s) { return s.stream().isMeasuring(); },
          "True while scan lines wait for the sensor to be measured.")
      .def_property_readonly(
          "measured_blocks", [](const LineStream& s) { return s.stream().measuredBlocks(); },
          "Flat image blocks that the sensor was measured on; 0: none were found, the model is generic.");
}

}  // namespace epcc::python
