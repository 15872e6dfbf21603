// SPDX-License-Identifier: BSD-3-Clause
// epcc.PixelContour, and the borders of any label image.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "epcc_segmentation/contours.h"
#include "errors.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

struct LabelImage {
  std::vector<std::int32_t> labels;
  int width, height;
};

LabelImage imageOf(const py::array& array) {
  const py::array_t<std::int32_t> labels = labelImage(array);
  return {{labels.data(), labels.data() + labels.size()},
          static_cast<int>(labels.shape(1)),
          static_cast<int>(labels.shape(0))};
}

std::vector<PixelContour> contoursOf(const py::array& labels, std::int32_t label) {
  const LabelImage image = imageOf(labels);
  const py::gil_scoped_release released;
  return traceContours(image.labels, image.width, image.height, label);
}

std::vector<std::vector<PixelContour>> allContoursOf(const py::array& labels, int label_count) {
  if (label_count < 0) throw py::value_error("label_count must not be negative");
  const LabelImage image = imageOf(labels);
  const py::gil_scoped_release released;
  return traceAllContours(image.labels, image.width, image.height, label_count);
}

py::array points(const py::object& self) {
  const auto& contour = self.cast<const PixelContour&>();
  return viewOf(contour.points, {static_cast<py::ssize_t>(contour.points.size()), py::ssize_t{2}}, self,
                py::dtype::of<std::int32_t>());
}

}  // namespace

void bindContours(py::module_& module) {
  static_assert(sizeof(Eigen::Vector2i) == 2 * sizeof(std::int32_t), "points are pairs in memory");
  py::class_<PixelContour>(module, "PixelContour", R"(One border of a region: a closed walk through its own pixels.

Neighbouring points, the last and the first too, are 8-neighbours. Outer borders run counter-clockwise on the picture,
those of holes clockwise; a part one pixel wide is walked there and back.)")
      .def_property_readonly("points", &points, "N x 2 int32: (column, row), closed implicitly.")
      .def_readonly("is_hole", &PixelContour::is_hole, "True for the border of a hole.")
      .def_property_readonly("signed_area", &signedArea,
                             "Area inside, pixels: positive for outer borders, negative for holes, 0 for lines.")
      .def("__repr__", [](const PixelContour& c) {
        return py::str("<epcc.PixelContour of {}, {} pixels>")
            .format(c.is_hole ? "a hole" : "a region", c.points.size());
      });
  module.def("trace_contours", &contoursOf, "labels"_a, "label"_a, R"(Borders of the pixels with one label.

labels: H x W integers, of this library or not; every other label and the outside count as background.
Outer borders first, the largest area first, then holes likewise; an empty list for a label that is 0, negative or not
there.)");
  module.def("trace_all_contours", &allContoursOf, "labels"_a, "label_count"_a,
             "Borders of the labels 1..label_count in one pass: [k] holds those of label k + 1, as trace_contours().");
}

}  // namespace epcc::python
