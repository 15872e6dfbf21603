// SPDX-License-Identifier: BSD-3-Clause
// The sensor measured: epcc.estimate_sensor(), SensorEstimator over a stream, SensorPool over many frames.
#include "epcc_segmentation/sensor_estimation.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "frames.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

using Camera = std::optional<PinholeCamera>;
using Scale = std::optional<double>;

/// An object that measures frames, and the geometry of clouds among them.
template <typename Measure>
struct Measuring {
  template <typename... Arguments>
  explicit Measuring(Arguments... arguments) : measure(arguments...) {}
  Exclusive<Measure> measure;
  Exclusive<GeometryFinder> finder;
};
using Stream = Measuring<SensorEstimator>;
using Pool = Measuring<SensorPool>;

SensorEstimate estimate(const py::object& data, const Camera& camera, Scale depth_scale) {
  Exclusive<GeometryFinder> finder;
  const ArrayFrame frame = frameOf(data, camera, depth_scale, finder);
  const py::gil_scoped_release released;
  return estimateSensor(frame.frame);
}

std::unique_ptr<Stream> stream(std::size_t memory, std::size_t interval) {
  if (memory < 1) throw py::value_error("memory must be at least 1");
  if (interval < 1 || interval > 150) throw py::value_error("interval must be in [1, 150]");
  return std::make_unique<Stream>(memory, interval);
}

SensorEstimate update(Stream& stream, const py::object& data, const Camera& camera, Scale depth_scale) {
  const ArrayFrame frame = frameOf(data, camera, depth_scale, stream.finder);
  return stream.measure.run([&](SensorEstimator& estimator) { return estimator.update(frame.frame); });
}

bool add(Pool& pool, const py::object& data, const Camera& camera, Scale depth_scale) {
  const ArrayFrame frame = frameOf(data, camera, depth_scale, pool.finder);
  return pool.measure.run([&](SensorPool& frames) { return frames.add(frame.frame); });
}

/// A property that looks at one of a measurement's vectors.
template <typename T>
py::cpp_function viewer(std::vector<T> SensorMeasurement::*values) {
  return [values](const py::object& self) {
    const std::vector<T>& own = self.cast<const SensorMeasurement&>().*values;
    return viewOf(own, {static_cast<py::ssize_t>(own.size())}, self);
  };
}

void bindEstimate(py::module_& module) {
  py::class_<SensorEstimate>(module, "SensorEstimate", "What frames tell of their sensor; model() for segment().")
      .def_readonly("a", &SensorEstimate::a, "Floor of sigma_z, metres, see SensorModel.axial().")
      .def_readonly("b", &SensorEstimate::b, "Growth with the square of the depth, 1/m.")
      .def_readonly("correlation_length", &SensorEstimate::correlation_length,
                    "Of the model, pixels, see SensorModel.correlation_length.")
      .def_readonly("blotch_length", &SensorEstimate::blotch_length, "Radius of the blotches that were seen, pixels.")
      .def_readonly("blotch_share", &SensorEstimate::blotch_share,
                    "Of the error's variance; the rest differs from pixel to pixel.")
      .def_readonly("effective_length", &SensorEstimate::effective_length,
                    "Of blotches alone with as many pixels a sample; 0.4 is grain alone.")
      .def_readonly("correlated_share", &SensorEstimate::correlated_share,
                    "Of the model's variance, in which whole surfaces err together, see SensorModel.correlated_share.")
      .def_readonly("blocks", &SensorEstimate::blocks,
                    "Flat image blocks that were measured; 0: nothing was, the values are generic.")
      .def("model", &SensorEstimate::model, "As a SensorModel.");
}

void bindMeasurement(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(SensorMeasurement::Block, depth, residual);
  PYBIND11_NUMPY_DTYPE(SensorMeasurement::Bin, depth, error, sigma, blocks);
  py::class_<SensorMeasurement>(module, "SensorMeasurement", "An estimate and what it comes from, for reports.")
      .def_readonly("estimate", &SensorMeasurement::estimate, "The SensorEstimate.")
      .def_property_readonly("blocks", viewer(&SensorMeasurement::blocks),
                             "Blocks of the image: depth (metres) and residual (rms that a quadric leaves, metres).")
      .def_property_readonly(
          "bins", viewer(&SensorMeasurement::bins),
          "Ranges of depths: depth, error (its standard deviation), sigma (what the model says), all metres, and "
          "blocks.")
      .def_readonly("grain", &SensorMeasurement::grain, "Variance of the grain, in a block's mean square.")
      .def_readonly("blotches", &SensorMeasurement::blotches, "Variance of the blotches, in a block's mean square.")
      .def_readonly("sides", &SensorMeasurement::sides, "Sides of the parts of a block, pixels.")
      .def_readonly("kept", &SensorMeasurement::kept, "Mean squares that quadrics in parts of these sides leave.")
      .def_readonly("kept_fit", &SensorMeasurement::kept_fit, "What grain and blotches say of them.")
      .def_property_readonly("correlation", viewer(&SensorMeasurement::correlation),
                             "Autocorrelation of the residuals at lags of 0, 1, ... pixels.")
      .def_property_readonly("correlation_fit", viewer(&SensorMeasurement::correlation_fit),
                             "What grain and blotches say of it.");
}

}  // namespace

void bindSensorEstimation(py::module_& module) {
  bindEstimate(module);
  bindMeasurement(module);
  module.def("estimate_sensor", &estimate, "frame"_a, "camera"_a = py::none(), "depth_scale"_a = py::none(),
             R"(Measures the sensor on one frame, in a fraction of a millisecond at 640x480.

frame, camera, depth_scale: as segment(). Fits quadrics to small blocks and reads the error off their residuals: its size
by depth, and how far it is correlated. SensorEstimate.blocks is 0 if nothing could be measured.)");
  py::class_<Stream>(module, "SensorEstimator", R"(The sensor measured over a stream of frames: medians, which settle.

memory: number of estimates that are remembered, at least 1.
interval: frames in a round, 1 to 150: once the memory is full, a frame measures every interval-th block.)")
      .def(py::init(&stream), "memory"_a = 15, "interval"_a = 4)
      .def("update", &update, "frame"_a, "camera"_a = py::none(), "depth_scale"_a = py::none(),
           "Measures a frame, as segment() takes it, and returns the SensorEstimate of the stream.")
      .def(
          "reset", [](Stream& s) { s.measure.run([](SensorEstimator& e) { e.reset(); }); }, "Starts afresh.");
  py::class_<Pool>(module, "SensorPool", "Frames of one camera pooled: all their blocks count as those of one frame.")
      .def(py::init<>())
      .def("add", &add, "frame"_a, "camera"_a = py::none(), "depth_scale"_a = py::none(),
           "Adds a frame, as segment() takes it; False, and it is left out, if its size is not that of the first.")
      .def_property_readonly(
          "frames", [](Pool& p) { return p.measure.run([](SensorPool& pool) { return pool.frames(); }); },
          "Number of frames so far.")
      .def(
          "measure", [](Pool& p) { return p.measure.run([](SensorPool& pool) { return pool.measure(); }); },
          "The SensorMeasurement of all frames so far; estimate.blocks is 0 if nothing could be measured.");
}

}  // namespace epcc::python
