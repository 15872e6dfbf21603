// SPDX-License-Identifier: BSD-3-Clause
// epcc.PinholeCamera.
#include <string>

#include "bindings.h"
#include "epcc_segmentation/depth_frame.h"
#include "errors.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

PinholeCamera camera(int width, int height, double fx, double fy, double cx, double cy) {
  const PinholeCamera camera{width, height, fx, fy, cx, cy};
  throwProblem(Status::InvalidCamera, camera.validate());
  return camera;
}

py::tuple values(const PinholeCamera& c) {
  return py::make_tuple(c.width, c.height, c.fx, c.fy, c.cx, c.cy);
}

std::string text(const PinholeCamera& c) {
  return py::str("epcc.PinholeCamera(width={}, height={}, fx={}, fy={}, cx={}, cy={})").format(*values(c));
}

}  // namespace

void bindCamera(py::module_& module) {
  py::class_<PinholeCamera>(module, "PinholeCamera", R"(Pinhole intrinsics in pixels.

The camera's frame is x right, y down, z forward; pixel centres are at whole numbers, so that a pixel (row, column) of
depth z metres is the point ((column - cx) / fx * z, (row - cy) / fy * z, z). InputError if a value is out of range:
focal lengths in [0.001, 1e6], the principal point within 1e6 pixels.)")
      .def(py::init(&camera), "width"_a, "height"_a, "fx"_a, "fy"_a, "cx"_a, "cy"_a)
      .def_readwrite("width", &PinholeCamera::width, "Columns of the depth image, pixels.")
      .def_readwrite("height", &PinholeCamera::height, "Rows of the depth image, pixels.")
      .def_readwrite("fx", &PinholeCamera::fx, "Focal length along the rows, pixels.")
      .def_readwrite("fy", &PinholeCamera::fy, "Focal length along the columns, pixels.")
      .def_readwrite("cx", &PinholeCamera::cx, "Column of the principal point, pixels.")
      .def_readwrite("cy", &PinholeCamera::cy, "Row of the principal point, pixels.")
      .def(
          "validate", [](const PinholeCamera& c) { throwProblem(Status::InvalidCamera, c.validate()); },
          "InputError, with what is wrong in words, if a value is out of its range.")
      .def("__eq__",
           [](const PinholeCamera& a, const py::object& b) {
             return py::isinstance<PinholeCamera>(b) && values(a).equal(values(b.cast<PinholeCamera>()));
           })
      .def("__repr__", &text)
      .def(py::pickle(&values, [](const py::tuple& v) {
        return PinholeCamera{v[0].cast<int>(),    v[1].cast<int>(),    v[2].cast<double>(),
                             v[3].cast<double>(), v[4].cast<double>(), v[5].cast<double>()};
      }));
}

}  // namespace epcc::python
