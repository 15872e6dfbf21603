// SPDX-License-Identifier: BSD-3-Clause
// epcc.StreamGeometry: the rays of a stream's scan lines.
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <vector>

#include "bindings.h"
#include "epcc_segmentation/stream_geometry.h"
#include "errors.h"
#include "words.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

using Kind = StreamGeometry::Kind;

const char* kindWord(Kind kind) {
  switch (kind) {
    case Kind::CameraColumns:
      return "camera-columns";
    case Kind::CameraRows:
      return "camera-rows";
    case Kind::Scanner:
      return "scanner";
    default:
      return "points";
  }
}

StreamGeometry usable(const StreamGeometry& geometry) {
  throwProblem(geometry.kind() < Kind::Scanner ? Status::InvalidCamera : Status::InvalidParameters,
               geometry.validate());
  return geometry;
}

StreamGeometry cameraColumns(const PinholeCamera& camera) {
  return usable(StreamGeometry::cameraColumns(camera));
}

StreamGeometry cameraRows(const PinholeCamera& camera) {
  return usable(StreamGeometry::cameraRows(camera));
}

StreamGeometry scanner(const std::vector<double>& elevations, double azimuth_step,
                       const std::optional<std::vector<double>>& ring_azimuths) {
  return usable(StreamGeometry::scanner(elevations, azimuth_step, ring_azimuths.value_or(std::vector<double>())));
}

StreamGeometry points(int height, const std::string& projection, double azimuth_step) {
  const std::optional<Projection> known = projectionOf(projection);
  if (!known)
    throwStatus(
        Status::InvalidParameters,
        "projection must be \"perspective\", \"perspective-backward\" or \"spherical\", not \"" + projection + "\"");
  return usable(StreamGeometry::points(height, *known, azimuth_step));
}

int ringShift(const StreamGeometry& geometry, int ring) {
  if (ring < 0 || ring >= geometry.height()) throw py::index_error("there is no ring " + std::to_string(ring));
  return geometry.ringShift(ring);
}

}  // namespace

void bindStreamGeometry(py::module_& module) {
  py::class_<StreamGeometry>(module, "StreamGeometry", R"(What the scan lines of a ScanLineStream are.

Made by one of its functions; InputError if that cannot be.)")
      .def_static("camera_columns", &cameraColumns, "camera"_a,
                  "Columns of a depth camera, for add_column(). A width of 0 is not known: any index is a column.")
      .def_static("camera_rows", &cameraRows, "camera"_a,
                  "Rows of a depth camera, as a rolling readout has them, for add_row(). A height of 0 is not known.")
      .def_static("scanner", &scanner, "elevations"_a, "azimuth_step"_a, "ring_azimuths"_a = py::none(),
                  R"(Columns of a spinning scanner, for add_column() and add_column_at().

elevations: of each ring above the horizon, radians, rising or falling from ring to ring.
azimuth_step: what the azimuth changes by from column to column, radians: positive to the left, counter-clockwise seen
  from above, negative clockwise.
ring_azimuths: of a scanner with staggered rings by how much each ring's ray lies to the left of the column's azimuth,
  radians, one a ring, within pi/4 and at most 4096 columns apart; None: all rays of a column have its azimuth. A scan
  line is then made of the rings of several columns that look at one azimuth, see ring_shift().)")
      .def_static("points", &points, "height"_a, "projection"_a, "azimuth_step"_a = 0.0,
                  R"(Columns of an organized cloud, for add_points(), in the sensor's frame.

height: points of a column. projection: "perspective" (x right, y down, z forward), "perspective-backward" (y up, z back)
or "spherical" (x forward, y left, z up). azimuth_step: of a scanner, radians, says how long a turn is; 0: there is none.)")
      .def_property_readonly(
          "kind", [](const StreamGeometry& g) { return kindWord(g.kind()); },
          "\"camera-columns\", \"camera-rows\", \"scanner\" or \"points\".")
      .def_property_readonly("height", &StreamGeometry::height, "Samples of a scan line.")
      .def_property_readonly("elevations", &StreamGeometry::elevations,
                             "Of a scanner: the elevation of each ring, radians.")
      .def_property_readonly("azimuth_step", &StreamGeometry::azimuthStep,
                             "From column to column, radians, positive to the left; 0: not known.")
      .def_property_readonly("ring_azimuths", &StreamGeometry::ringAzimuths,
                             "Of a scanner with staggered rings: to the left of the column's azimuth, radians.")
      .def_property_readonly("is_staggered", &StreamGeometry::isStaggered,
                             "Whether rings of one column look at different azimuths.")
      .def_property_readonly(
          "projection", [](const StreamGeometry& g) { return projectionWord(g.projection()); },
          "How the scan lines see the world: \"perspective\", \"perspective-backward\" or \"spherical\".")
      .def("ring_shift", &ringShift, "ring"_a, R"(Columns by which a ring lags, as ScanGrid.ring_shift.

Its sample in scan line i came with column i + ring_shift(ring); 0 where rings are not staggered.)")
      .def("__repr__", [](const StreamGeometry& g) {
        return py::str("<epcc.StreamGeometry {}, {} samples a line{}>")
            .format(kindWord(g.kind()), g.height(), g.isStaggered() ? ", staggered" : "");
      });
}

}  // namespace epcc::python
