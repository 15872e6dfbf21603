// SPDX-License-Identifier: BSD-3-Clause
// Frames that look into numpy arrays.
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <memory>
#include <optional>

#include "epcc_segmentation/cloud_geometry.h"
#include "epcc_segmentation/depth_frame.h"
#include "exclusive.h"

namespace epcc::python {

/// Python's DepthFrame: the view, and what it looks into.
struct ArrayFrame {
  DepthFrame frame;
  pybind11::list arrays;                    // kept alive
  std::shared_ptr<CloudGeometry> geometry;  // of a cloud, else null
};

/// The memory of an H x W x 3 array.
struct CloudArray {
  const float* xyz;
  std::size_t stride;  // floats from point to point
  int width;
  int height;
};

/// All of these throw epcc.InputError for arrays of the wrong shape or memory layout, and TypeError for those of the
/// wrong type.
CloudArray cloudArray(const pybind11::array& points);
/// depth: H x W uint16 or float32 with any row stride.
ArrayFrame depthFrame(const pybind11::array& depth, const PinholeCamera& camera, std::optional<double> depth_scale,
                      const DepthOptions& options);
ArrayFrame cloudFrame(const pybind11::array& points, std::shared_ptr<CloudGeometry> geometry);
ArrayFrame maskedFrame(const ArrayFrame& frame, const pybind11::array& mask);

/// The geometry of a cloud. Throws epcc.InputError where there is none.
std::shared_ptr<CloudGeometry> foundGeometry(Exclusive<GeometryFinder>& finder, const pybind11::array& points,
                                             const CloudOptions& options);

/// What functions take as a frame: a DepthFrame, a depth image with its camera, or a cloud, whose geometry `finder`
/// finds.
ArrayFrame frameOf(const pybind11::object& data, const std::optional<PinholeCamera>& camera,
                   std::optional<double> depth_scale, Exclusive<GeometryFinder>& finder);

}  // namespace epcc::python
