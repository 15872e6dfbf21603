// SPDX-License-Identifier: BSD-3-Clause
// epcc.Plane.
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>

#include "arrays.h"
#include "bindings.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "errors.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

using Points = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Number of points in an array whose last axis is x, y, z.
py::ssize_t pointCount(const Points& points) {
  if (points.ndim() == 0 || points.shape(points.ndim() - 1) != 3)
    throwStatus(Status::SizeMismatch, "points are arrays of shape (..., 3), not " + shapeText(points));
  return points.size() / 3;
}

std::vector<py::ssize_t> shapeOf(const Points& points) {
  return {points.shape(), points.shape() + points.ndim()};
}

py::object signedDistance(const Plane& plane, const Points& points) {
  const py::ssize_t count = pointCount(points);
  std::vector<py::ssize_t> shape = shapeOf(points);
  shape.pop_back();
  py::array_t<double> distances(shape);
  const double* point = points.data();
  double* distance = distances.mutable_data();
  for (py::ssize_t i = 0; i < count; ++i)
    distance[i] = plane.signedDistance(Eigen::Map<const Eigen::Vector3d>(point + 3 * i));
  return shape.empty() ? py::object(py::float_(*distance)) : py::object(distances);
}

py::array_t<double> project(const Plane& plane, const Points& points) {
  const py::ssize_t count = pointCount(points);
  py::array_t<double> projected(shapeOf(points));
  const double* point = points.data();
  double* to = projected.mutable_data();
  for (py::ssize_t i = 0; i < count; ++i)
    Eigen::Map<Eigen::Vector3d>(to + 3 * i) = plane.project(Eigen::Map<const Eigen::Vector3d>(point + 3 * i));
  return projected;
}

std::string text(const Plane& plane) {
  const Vector4& p = plane.coefficients;
  return py::str("<epcc.Plane {:.4f} x + {:.4f} y + {:.4f} z + {:.4f} = 0, {} pixels, rms {:.4f} m>")
      .format(p(0), p(1), p(2), p(3), plane.pixel_count, plane.rms);
}

py::tuple values(const Plane& p) {
  return py::make_tuple(Vector4(p.coefficients), Matrix4(p.coefficients_covariance), Vector3(p.centroid),
                        Matrix3(p.points_covariance), p.rms, p.pixel_count, p.confidence);
}

Plane fromValues(const py::tuple& v) {
  return {v[0].cast<Vector4>(), v[1].cast<Matrix4>(),     v[2].cast<Vector3>(), v[3].cast<Matrix3>(),
          v[4].cast<double>(),  v[5].cast<std::size_t>(), v[6].cast<double>()};
}

}  // namespace

void bindPlane(py::module_& module) {
  py::class_<Plane>(module, "Plane", R"(One plane, metres, in the sensor's frame, of a cloud in the cloud's.

Its arrays are read-only views.)")
      .def_readonly("coefficients", &Plane::coefficients,
                    "4 float64, (a, b, c, d): a x + b y + c z + d = 0, unit normal towards the sensor; d >= 0 is the "
                    "distance of a sensor at the origin.")
      .def_readonly("coefficients_covariance", &Plane::coefficients_covariance,
                    "4 x 4 float64: covariance of (a, b, c, d), from residuals and the sensor's correlation length.")
      .def_readonly("centroid", &Plane::centroid, "3 float64: mean of the plane's points, metres.")
      .def_readonly("points_covariance", &Plane::points_covariance,
                    "3 x 3 float64: covariance of the points about the centroid, normalised by N, m^2.")
      .def_readonly("rms", &Plane::rms, "Root mean square of the points' orthogonal distances, metres.")
      .def_readonly("pixel_count", &Plane::pixel_count, "Number of pixels.")
      .def_readonly("confidence", &Plane::confidence,
                    "How likely this is a surface and not clutter, 0 to 1 (S9); 1 in the paper mode.")
      .def("signed_distance", &signedDistance, "points"_a,
           "Distance of points (..., 3) from the plane, metres, positive on the sensor's side: a float or an array.")
      .def("project", &project, "points"_a, "Orthogonal projection of points (..., 3) on the plane (Eq. 28).")
      .def("__repr__", &text)
      .def(py::pickle(&values, &fromValues));
}

}  // namespace epcc::python
