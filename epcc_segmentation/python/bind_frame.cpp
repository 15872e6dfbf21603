// SPDX-License-Identifier: BSD-3-Clause
// epcc.DepthFrame: a view on a depth image or an organized cloud.
#include <pybind11/stl.h>

#include <cmath>
#include <limits>

#include "bindings.h"
#include "frames.h"
#include "words.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

ArrayFrame fromDepth(const py::array& depth, const PinholeCamera& camera, std::optional<double> depth_scale,
                     bool is_distance, std::optional<double> invalid, double min_depth, double max_depth) {
  DepthOptions options;
  options.is_distance = is_distance;
  options.invalid = invalid;
  options.min_depth = min_depth;
  options.max_depth = max_depth;
  return depthFrame(depth, camera, depth_scale, options);
}

ArrayFrame fromPoints(const py::array& points, const CloudOptions& options, std::shared_ptr<CloudGeometry> geometry) {
  if (geometry) return cloudFrame(points, geometry);
  Exclusive<GeometryFinder> finder;
  return cloudFrame(points, foundGeometry(finder, points, options));
}

/// x, y, z of all pixels, NaN where nothing was measured.
void writePoints(const DepthFrame& frame, float* next) {
  for (int row = 0; row < frame.height(); ++row) {
    for (int column = 0; column < frame.width(); ++column) {
      Eigen::Vector3d point;
      if (!frame.point(row, column, point)) point.setConstant(std::numeric_limits<double>::quiet_NaN());
      for (int i = 0; i < 3; ++i) *next++ = static_cast<float>(point(i));
    }
  }
}

py::array_t<float> pointsOf(const ArrayFrame& owner) {
  const std::vector<py::ssize_t> shape = {owner.frame.height(), owner.frame.width(), 3};
  py::array_t<float> points(shape);
  float* memory = points.mutable_data();
  {
    const py::gil_scoped_release released;
    writePoints(owner.frame, memory);
  }
  return points;
}

}  // namespace

void bindFrame(py::module_& module) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  py::class_<ArrayFrame>(module, "DepthFrame", R"(A view on a depth image or an organized cloud; nothing is copied.

The array stays alive with the frame. Do not write to it while another thread segments the frame. segment() and its kin
also take arrays themselves; a DepthFrame says more about how they are to be read.)")
      .def_static("from_depth", &fromDepth, "depth"_a, "camera"_a, "depth_scale"_a = py::none(), py::kw_only(),
                  "is_distance"_a = false, "invalid"_a = py::none(), "min_depth"_a = 0.0, "max_depth"_a = kInfinity,
                  R"(A depth image of the camera's size.

depth: H x W, float32 in metres (<= 0, NaN and Inf are invalid) or uint16 in millimetres (0 and 65535 are invalid), with
  any row stride, a padded or flipped image for example.
depth_scale: metres per unit, where it is another one.
is_distance: values are lengths of the rays instead of depths.
invalid: one more value of the image, in its units, that stands for nothing measured.
min_depth, max_depth: what is nearer or farther is invalid, metres.
InputError if sizes, strides, camera, scale or range of depths cannot be used, TypeError for other types of numbers.)")
      .def_static("from_points", &fromPoints, "points"_a, "options"_a = CloudOptions(), py::kw_only(),
                  "geometry"_a = py::none(),
                  R"(An organized cloud of a camera or a scanner, in any frame and unit.

points: H x W x 3 float32 (every n-th float of a larger array too, as cloud[..., :3]), NaN where nothing was measured.
options: what is known of the cloud, see CloudOptions.
geometry: what find_geometry() or GeometryFinder found for this cloud or one of the same sensor; else it is searched.
InputError if neither a camera nor a scanner sees the points so.)")
      .def("masked", &maskedFrame, "mask"_a, "The same frame without the pixels whose mask (H x W bool or uint8) is 0.")
      .def("points", &pointsOf, R"(The points: H x W x 3 float32, metres, NaN where nothing was measured.

In the camera's frame (x right, y down, z forward), of a cloud in the cloud's.)")
      .def_property_readonly(
          "width", [](const ArrayFrame& f) { return f.frame.width(); }, "Columns, pixels.")
      .def_property_readonly(
          "height", [](const ArrayFrame& f) { return f.frame.height(); }, "Rows, pixels.")
      .def_property_readonly(
          "projection", [](const ArrayFrame& f) { return projectionWord(f.frame.projection()); },
          "\"perspective\", \"perspective-backward\" (seen along -z with y up) or \"spherical\".")
      .def_property_readonly(
          "geometry", [](const ArrayFrame& f) { return f.geometry; },
          "CloudGeometry of a cloud, None of a depth image.")
      .def("__repr__", [](const ArrayFrame& f) {
        return py::str("<epcc.DepthFrame {}x{} {}>")
            .format(f.frame.width(), f.frame.height(), projectionWord(f.frame.projection()));
      });
}

}  // namespace epcc::python
