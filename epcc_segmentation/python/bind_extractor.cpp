// SPDX-License-Identifier: BSD-3-Clause
// epcc.segment(), epcc.PlaneExtractor over a stream, epcc.fit_planes() and epcc.fit_lines().
#include <pybind11/stl.h>

#include <algorithm>

#include "arrays.h"
#include "bindings.h"
#include "epcc_segmentation/line_fit.h"
#include "epcc_segmentation/plane_fit.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "errors.h"
#include "frames.h"
#include "segmentation.h"
#include "sensors.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

using SharedParameters = std::shared_ptr<Parameters>;
using Camera = std::optional<PinholeCamera>;
using Scale = std::optional<double>;

/// The library's extractor with the parameters that Python changes in place, and the geometry of clouds.
class Extractor {
 public:
  Extractor(SharedParameters parameters, const py::object& sensor)
      : parameters_(parameters ? std::move(parameters) : std::make_shared<Parameters>()),
        extractor_(*parameters_, sensorOf(sensor)) {}

  std::unique_ptr<Segmentation> extract(const py::object& data, const Camera& camera, Scale depth_scale) {
    const ArrayFrame frame = frameOf(data, camera, depth_scale, finder_);
    const Parameters parameters = *parameters_;
    std::string error;
    Status status = Status::Ok;
    auto result = extractor_.run([&](PlaneExtractor& extractor) {
      PlaneSegmentation found;
      extractor.setParameters(parameters);
      extractor.extract(frame.frame, found);
      status = extractor.status();
      error = extractor.error();
      return std::unique_ptr<Segmentation>(
          new Segmentation{std::move(found), extractor.sensor(), extractor.times(), frame.geometry});
    });
    if (status != Status::Ok) throwStatus(status, error);
    return result;
  }

  const SharedParameters& parameters() const { return parameters_; }
  void setParameters(const SharedParameters& parameters) { parameters_ = parameters; }
  SensorModel sensor() {
    return extractor_.run([](PlaneExtractor& extractor) { return extractor.sensor(); });
  }
  bool measuresSensor() {
    return extractor_.run([](PlaneExtractor& extractor) { return extractor.measuresSensor(); });
  }
  void setSensor(const py::object& sensor) {
    const std::optional<SensorModel> model = sensorOf(sensor);
    extractor_.run([&](PlaneExtractor& extractor) { model ? extractor.setSensor(*model) : extractor.setSensorAuto(); });
  }

 private:
  SharedParameters parameters_;
  Exclusive<PlaneExtractor> extractor_;
  Exclusive<GeometryFinder> finder_;
};

std::unique_ptr<Segmentation> segment(const py::object& data, const Camera& camera, const SharedParameters& parameters,
                                      const py::object& sensor, Scale depth_scale) {
  return Extractor(parameters, sensor).extract(data, camera, depth_scale);
}

/// The frame with these labels, and what `fill` makes of them with the sensor.
template <typename Fill>
std::unique_ptr<Segmentation> labelled(const ArrayFrame& frame, const py::object& sensor, const py::array& label_array,
                                       const Fill& fill) {
  const py::array_t<std::int32_t> labels = labelImage(label_array);
  if (labels.shape(0) != frame.frame.height() || labels.shape(1) != frame.frame.width())
    throwStatus(Status::SizeMismatch, "the labels' shape " + shapeText(labels) + " is not that of the frame");
  std::optional<SensorModel> model = sensorOf(sensor);
  const py::gil_scoped_release released;
  if (!model) model = estimateSensor(frame.frame).model();
  PlaneSegmentation data;
  data.width = frame.frame.width();
  data.height = frame.frame.height();
  data.labels.assign(labels.data(), labels.data() + labels.size());
  fill(*model, data);
  return std::unique_ptr<Segmentation>(new Segmentation{std::move(data), *model, StageTimes(), frame.geometry});
}

std::unique_ptr<Segmentation> fit(const ArrayFrame& frame, const py::object& sensor, const py::array& labels) {
  return labelled(frame, sensor, labels, [&](const SensorModel& model, PlaneSegmentation& data) {
    const std::int32_t largest = *std::max_element(data.labels.begin(), data.labels.end());
    fitPlanes(frame.frame, model, std::max(0, largest), data);
  });
}

std::unique_ptr<Segmentation> fitSegments(const ArrayFrame& frame, const py::object& sensor, const py::array& labels) {
  return labelled(frame, sensor, labels, [&](const SensorModel& model, PlaneSegmentation& data) {
    fitLines(frame.frame, model, ScanDirection::Both, data);
  });
}

}  // namespace

void bindExtractor(py::module_& module) {
  py::class_<Extractor>(module, "PlaneExtractor", R"(Segments a stream of frames into planes.

Keeps its memory from frame to frame, and the sensor, where it is measured, settles over them. Other Python threads go
on while it works; threads that share one extractor take turns.

parameters: Parameters, which may be changed between frames: extractor.parameters.threads = 4.
sensor: None or "auto" (measured on the frames), a SensorModel, or a text as SensorModel.parse() reads it.)")
      .def(py::init<SharedParameters, const py::object&>(), "parameters"_a = py::none(), "sensor"_a = py::none())
      .def("extract", &Extractor::extract, "frame"_a, "camera"_a = py::none(), "depth_scale"_a = py::none(),
           "Segments one frame, as segment() takes it; a new PlaneSegmentation, which later frames do not change.")
      .def_property("parameters", &Extractor::parameters, &Extractor::setParameters,
                    "The Parameters of the frames to come.")
      .def_property("sensor", &Extractor::sensor, &Extractor::setSensor, R"(The SensorModel of the last frame.

Before the first frame what was given. Set it to a model, a text, or None or "auto", which starts measuring afresh.)")
      .def_property_readonly("measures_sensor", &Extractor::measuresSensor, "True if the sensor is measured.");
  module.def("segment", &segment, "frame"_a, "camera"_a = py::none(), "parameters"_a = py::none(),
             "sensor"_a = py::none(), py::kw_only(), "depth_scale"_a = py::none(), R"(Segments one frame into planes.

frame: a depth image, H x W, float32 in metres or uint16 in millimetres, with its camera; or an organized cloud,
  H x W x 3 float32 in any frame, of a camera or a scanner; or a DepthFrame. Nothing is copied: any row stride will do.
camera: PinholeCamera of a depth image.
parameters: Parameters; None: the defaults.
sensor: None or "auto": measured on the frame; a SensorModel; or a text as SensorModel.parse() reads it, "kinect-v1".
depth_scale: metres per unit of a depth image; None: 0.001 of uint16, 1 of float32.

A frame without a single valid pixel is no error: no planes. InputError (a ValueError) for what cannot be used, with
`status`; TypeError for arrays of other types; OutOfMemoryError. Other Python threads go on meanwhile. For a stream of
frames keep a PlaneExtractor.)");
  module.def("fit_planes", &fit, "frame"_a, "sensor"_a, "labels"_a, R"(Least-squares planes of labelled pixels.

frame: DepthFrame; sensor: as segment(); labels: H x W integers, 0 and below for no plane, of any program.
Orthogonal least squares, each point weighted by 1 / sigma_z^2. The planes, and the labels with them, are sorted by
pixel count, and labels without pixels dropped.)");
  module.def("fit_lines", &fitSegments, "frame"_a, "sensor"_a, "labels"_a, R"(Line segments of labelled pixels.

frame, sensor, labels: as fit_planes(). What is in sequence of one label in a column or a row, three measured pixels at
least, is one of the result's `segments`; those of all columns, then those of all rows. It has no planes.)");
}

}  // namespace epcc::python
