// SPDX-License-Identifier: BSD-3-Clause
// epcc.PlaneSegmentation: labels and line segments as views on the result's memory, planes, contours.
#include "segmentation.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "epcc_segmentation/contours.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

py::array labels(const py::object& self) {
  const PlaneSegmentation& data = self.cast<const Segmentation&>().data;
  return viewOf(data.labels, {data.height, data.width}, self);
}

py::list planes(const py::object& self) {
  py::list list;
  for (Plane& plane : self.cast<Segmentation&>().data.planes)
    list.append(py::cast(&plane, py::return_value_policy::reference_internal, self));
  return list;
}

/// One record for each field of LineSegment, at its place in it.
py::dtype segmentType() {
  const LineSegment s;
  py::list names, formats, offsets;
  const auto add = [&](const char* name, const char* format, const void* field) {
    names.append(name);
    formats.append(py::dtype(format));
    offsets.append(static_cast<const char*>(field) - reinterpret_cast<const char*>(&s));
  };
  static_assert(sizeof(ScanDirection) == 4, "read as int32");
  add("scan", "i4", &s.scan);
  add("line", "i4", &s.line);
  add("first", "i4", &s.first);
  add("last", "i4", &s.last);
  add("samples", "i4", &s.samples);
  add("label", "i4", &s.label);
  add("start", "(3,)f8", &s.start);
  add("end", "(3,)f8", &s.end);
  add("mean", "(2,)f8", &s.mean);
  add("covariance", "(2,2)f8", &s.covariance);
  add("variance", "f8", &s.variance);
  add("theta", "(2,)f8", &s.theta);
  add("theta_covariance", "(2,2)f8", &s.theta_covariance);
  return {names, formats, offsets, static_cast<py::ssize_t>(sizeof(LineSegment))};
}

py::array segments(const py::object& self) {
  const auto& all = self.cast<const Segmentation&>().data.segments;
  return viewOf(all, {static_cast<py::ssize_t>(all.size())}, self, segmentType());
}

std::vector<PixelContour> contours(const Segmentation& s, std::int32_t label) {
  const py::gil_scoped_release released;
  return traceContours(s.data.labels, s.data.width, s.data.height, label);
}

std::vector<std::vector<PixelContour>> allContours(const Segmentation& s) {
  const py::gil_scoped_release released;
  return traceAllContours(s.data.labels, s.data.width, s.data.height, static_cast<int>(s.data.planes.size()));
}

void bindTimes(py::module_& module) {
  py::class_<StageTimes>(module, "StageTimes", "Wall-clock seconds of a segmentation, by stage.")
      .def_readonly("read", &StageTimes::read, "Depth to inverse depth.")
      .def_readonly("sensor", &StageTimes::sensor, "The sensor measured, where no model was given.")
      .def_readonly("lines", &StageTimes::lines, "Scan lines to line segments (Algorithm 1, S1).")
      .def_readonly("planes", &StageTimes::planes, "Line segments to planes (Algorithm 2, S2).")
      .def_readonly("regions", &StageTimes::regions, "Join, merge, refine, reject (S3 to S9).")
      .def_readonly("result", &StageTimes::result, "Labels, least-squares planes, line segments if asked for.")
      .def_property_readonly("total", &StageTimes::total, "All of them.");
}

void bindDoubts(py::module_& module) {
  py::class_<Doubts>(module, "Doubts", "What speaks against a result although nothing failed.")
      .def_readonly("sensor_is_generic", &Doubts::sensor_is_generic,
                    "The sensor was to be measured and could not be: a generic model was used.")
      .def_readonly("error_share", &Doubts::error_share,
                    "The measured error at the median depth, divided by that depth; doubtful from 0.1 on.")
      .def_readonly("jump_share", &Doubts::jump_share,
                    "Of neighbours whose depths differ, the share that differs by over a tenth; doubtful from 0.1 on.")
      .def_readonly("scattered_share", &Doubts::scattered_share,
                    "Share of the pixels that are measured, if they are scattered, else 1; doubtful below 0.05.")
      .def_readonly("limit_share", &Doubts::limit_share,
                    "Share of the pixels at exactly the largest or smallest depth, if these stand apart; doubtful from "
                    "0.01 on.")
      .def_readonly("limit_depth", &Doubts::limit_depth, "That depth, metres; 0 if limit_share is.")
      .def_readonly("bytes_are_swapped", &Doubts::bytes_are_swapped,
                    "Of uint16 images: the values are smooth only once the two bytes of each are swapped.")
      .def("any", &Doubts::any, "Whether there is anything to say.")
      .def("in_words", &Doubts::inWords, "One line; empty if there is nothing to say.")
      .def("__repr__", [](const Doubts& doubts) { return py::str("<epcc.Doubts '{}'>").format(doubts.inWords()); });
}

}  // namespace

void bindSegmentation(py::module_& module) {
  bindTimes(module);
  bindDoubts(module);
  py::class_<Segmentation>(module, "PlaneSegmentation", "The result of a segmentation.")
      .def_property_readonly("labels", &labels, R"(H x W int32: 0 for no plane, else k for planes[k - 1].

A view on the result's memory, without a copy.)")
      .def_property_readonly("planes", &planes, "The planes, a list of Plane, the one of most pixels first.")
      .def_property_readonly("segments", &segments,
                             R"(Line segments, if Parameters.line_segments asks for them; those of fit_lines().

A structured array, a view without a copy; those of the columns, then those of the rows. Fields:
scan: 0 a part of an image column, 1 of a row; line: which column or row.
first, last: rows or columns in it of the first and the last sample; samples: how many it took.
label: 0 or the plane, as in labels.
start, end: first and last sample on the line, 3 metres in the sensor's frame.
mean, covariance, variance: of the samples (t1, t2) in the section, metres and m^2, see LineSegment in C++.
theta, theta_covariance: the line theta . (t1, t2) = 1, 1/m, and its covariance, 1/m^2, 0 if it is not known. The
  error is taken to be correlated along the scan line as it was measured, or as the sensor's model says.)")
      .def("contours", &contours, "label"_a, "Borders of the plane with this label, as trace_contours(labels, label).")
      .def("all_contours", &allContours, "Borders of all planes in one pass: [k] holds those of planes[k].")
      .def_readonly("sensor", &Segmentation::sensor, "The SensorModel that was used: measured, or adapted (S0).")
      .def_property_readonly(
          "doubts", [](const Segmentation& s) -> const Doubts& { return s.data.doubts; },
          py::return_value_policy::reference_internal, "Doubts: what makes the planes doubtful.")
      .def_readonly("times", &Segmentation::times, "StageTimes.")
      .def_readonly("geometry", &Segmentation::geometry, "CloudGeometry of a cloud, None of a depth image.")
      .def("__repr__", [](const Segmentation& s) {
        return py::str("<epcc.PlaneSegmentation {}x{}, {} planes>")
            .format(s.data.width, s.data.height, s.data.planes.size());
      });
}

}  // namespace epcc::python
