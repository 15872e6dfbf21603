// SPDX-License-Identifier: BSD-3-Clause
// From numpy's shapes, types and strides to views of the library, each checked before its memory is looked at.
#include "frames.h"

#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "arrays.h"
#include "errors.h"

namespace py = pybind11;

namespace epcc::python {

namespace {

constexpr const char* kOrMasked = ", or use DepthFrame.masked()";
constexpr py::ssize_t kMostPixels = std::numeric_limits<int>::max();

/// Rows and columns of an array of pixels as the library's ints.
std::pair<int, int> sizeOf(const py::array& array, const char* what) {
  if (array.shape(0) == 0 || array.shape(1) == 0) throwStatus(Status::EmptyCloud, std::string(what) + " is empty");
  if (array.shape(0) > kMostPixels || array.shape(1) > kMostPixels)
    throwStatus(Status::SizeMismatch, std::string(what) + " is too large");
  return {static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1))};
}

template <typename T>
ArrayFrame viewedDepth(const py::array& depth, const PinholeCamera& camera, std::optional<double> depth_scale,
                       const DepthOptions& options) {
  const auto [height, width] = sizeOf(depth, "the depth image");
  if (width > 1 && depth.strides(1) != static_cast<py::ssize_t>(sizeof(T)))
    throwStatus(Status::SizeMismatch,
                "the depth image's columns do not adjoin in memory: pass numpy.ascontiguousarray(depth)");
  // A stride of 0 means adjoining rows to the library, and one row repeated to numpy.
  if (height > 1 && depth.strides(0) == 0)
    throwStatus(Status::SizeMismatch, "the depth image's row stride, in bytes, is less than a row");
  DepthView<T> view{static_cast<const T*>(depth.data()), width, height, height > 1 ? depth.strides(0) : 0};
  if (depth_scale) view.scale = *depth_scale;
  const DepthFrame frame = DepthFrame::fromDepth(view, camera).readAs(options);
  if (frame.empty()) throwStatus(frame.status(), frame.problem());
  py::list arrays;
  arrays.append(depth);
  return {frame, arrays, nullptr};
}

}  // namespace

ArrayFrame depthFrame(const py::array& depth, const PinholeCamera& camera, std::optional<double> depth_scale,
                      const DepthOptions& options) {
  refuseMasked(depth, kOrMasked);
  if (depth.ndim() != 2) throwStatus(Status::SizeMismatch, "a depth image is H x W, not " + shapeText(depth));
  throwProblem(Status::InvalidCamera, camera.validate());
  if (py::isinstance<py::array_t<std::uint16_t>>(depth))
    return viewedDepth<std::uint16_t>(depth, camera, depth_scale, options);
  if (py::isinstance<py::array_t<float>>(depth)) return viewedDepth<float>(depth, camera, depth_scale, options);
  throwTypeError("a depth image is uint16 or float32, not " + typeText(depth));
}

CloudArray cloudArray(const py::array& points) {
  refuseMasked(points, kOrMasked);
  if (points.ndim() != 3 || points.shape(2) != 3)
    throwStatus(Status::SizeMismatch, "a cloud is H x W x 3, not " + shapeText(points));
  if (!py::isinstance<py::array_t<float>>(points)) throwTypeError("a cloud is float32, not " + typeText(points));
  const auto [height, width] = sizeOf(points, "the cloud");
  constexpr auto kFloat = static_cast<py::ssize_t>(sizeof(float));
  const py::ssize_t step = width > 1 ? points.strides(1) : height > 1 ? points.strides(0) : 3 * kFloat;
  const bool rows_adjoin = height == 1 || points.strides(0) == step * width;
  const bool aligned = reinterpret_cast<std::uintptr_t>(points.data()) % alignof(float) == 0 && step % kFloat == 0;
  if (points.strides(2) != kFloat || step < 3 * kFloat || !rows_adjoin || !aligned)
    throwStatus(Status::SizeMismatch,
                "the cloud's points do not follow one another in memory: pass numpy.ascontiguousarray(points)");
  return {static_cast<const float*>(points.data()), static_cast<std::size_t>(step / kFloat), width, height};
}

ArrayFrame cloudFrame(const py::array& points, std::shared_ptr<CloudGeometry> geometry) {
  const CloudArray cloud = cloudArray(points);
  const DepthFrame frame = DepthFrame::fromPoints(cloud.xyz, cloud.stride, cloud.width, cloud.height, *geometry);
  if (frame.empty()) throwStatus(frame.status(), frame.problem());
  py::list arrays;
  arrays.append(points);
  return {frame, arrays, std::move(geometry)};
}

ArrayFrame maskedFrame(const ArrayFrame& frame, const py::array& mask) {
  if (mask.ndim() != 2 || mask.shape(0) != frame.frame.height() || mask.shape(1) != frame.frame.width())
    throwStatus(Status::SizeMismatch, "the mask's shape " + shapeText(mask) + " is not that of the frame");
  if (mask.itemsize() != 1 || !(mask.dtype().kind() == 'b' || mask.dtype().kind() == 'u'))
    throwTypeError("a mask is bool or uint8, not " + typeText(mask));
  if (!(mask.flags() & py::array::c_style))
    throwStatus(Status::SizeMismatch, "the mask is not contiguous: pass numpy.ascontiguousarray(mask)");
  py::list arrays;
  for (const py::handle& array : frame.arrays) arrays.append(array);
  arrays.append(mask);
  return {frame.frame.masked(static_cast<const std::uint8_t*>(mask.data())), arrays, frame.geometry};
}

std::shared_ptr<CloudGeometry> foundGeometry(Exclusive<GeometryFinder>& finder, const py::array& points,
                                             const CloudOptions& options) {
  const CloudArray cloud = cloudArray(points);
  auto geometry = finder.run([&](GeometryFinder& free_finder) {
    return std::make_shared<CloudGeometry>(
        free_finder.find(cloud.xyz, cloud.stride, cloud.width, cloud.height, options));
  });
  if (geometry->status != Status::Ok) throwStatus(geometry->status, geometry->problem);
  return geometry;
}

ArrayFrame frameOf(const py::object& data, const std::optional<PinholeCamera>& camera,
                   std::optional<double> depth_scale, Exclusive<GeometryFinder>& finder) {
  const bool is_frame = py::isinstance<ArrayFrame>(data);
  if (is_frame && (camera || depth_scale)) throwTypeError("a DepthFrame has its camera and its depth scale already");
  if (is_frame) return data.cast<ArrayFrame>();
  if (data.is_none()) throwTypeError("there is no depth image and no cloud: None was given");
  const auto array = py::isinstance<py::array>(data) ? py::array(data) : py::array::ensure(data);
  if (!array) throw py::error_already_set();
  if (array.ndim() != 3) {
    if (!camera && array.ndim() == 2) throwTypeError("a depth image needs its camera: epcc.PinholeCamera(...)");
    return depthFrame(array, camera.value_or(PinholeCamera{1, 1, 1.0, 1.0}), depth_scale, DepthOptions());
  }
  if (camera || depth_scale) throwTypeError("a cloud of H x W x 3 points has no camera and no depth scale");
  return cloudFrame(array, foundGeometry(finder, array, CloudOptions()));
}

}  // namespace epcc::python
