// SPDX-License-Identifier: BSD-3-Clause
// epcc.SensorModel, and how functions take a sensor: a model, a text or nothing.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>

#include "bindings.h"
#include "epcc_segmentation/sensor_model.h"
#include "errors.h"
#include "sensors.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

SensorModel parsed(const std::string& text) {
  std::string why;
  const std::optional<SensorModel> model = SensorModel::parse(text, &why);
  if (!model) throwStatus(Status::InvalidParameters, why);
  return *model;
}

SensorModel preset(const std::string& name) {
  const std::optional<SensorModel> model = SensorModel::preset(name);
  if (model) return *model;
  std::string names;
  for (const std::string& known : SensorModel::presetNames()) names += (names.empty() ? "" : ", ") + known;
  throwStatus(Status::InvalidParameters, "'" + name + "' is no preset (" + names + ")");
}

/// Checked: a model that cannot be used is refused where it is made.
SensorModel usable(const SensorModel& model) {
  throwProblem(Status::InvalidParameters, model.validate());
  return model;
}

/// The library's formulas are for depths that were measured, and have a smallest value.
template <double (SensorModel::*formula)(double) const>
double whereKnown(const SensorModel* model, double z) {
  return std::isnan(z) ? z : (model->*formula)(z);
}

py::tuple values(const SensorModel& model) {
  return py::make_tuple(model.isPolynomial(), model.coefficients(), model.correlationLength(), model.correlatedShare());
}

SensorModel fromValues(const py::tuple& v) {
  const auto k = v[1].cast<std::array<double, 3>>();
  const double length = v[2].cast<double>();
  const SensorModel model =
      v[0].cast<bool>() ? SensorModel::polynomial(k[0], k[1], k[2], length) : SensorModel::axial(k[0], k[1], length);
  return v.size() > 3 ? model.withCorrelatedShare(v[3].cast<double>()) : model;
}

}  // namespace

std::optional<SensorModel> sensorOf(const py::handle& sensor) {
  if (sensor.is_none()) return std::nullopt;
  if (py::isinstance<SensorModel>(sensor)) return sensor.cast<SensorModel>();
  if (!py::isinstance<py::str>(sensor))
    throwTypeError("sensor must be None, a str or an epcc.SensorModel, not " +
                   std::string(py::str(py::type::handle_of(sensor).attr("__name__"))));
  const auto text = sensor.cast<std::string>();
  return text == "auto" ? std::nullopt : std::optional<SensorModel>(parsed(text));
}

void bindSensorModel(py::module_& module) {
  py::class_<SensorModel>(module, "SensorModel", R"(Noise model of a depth sensor.

The error of a depth z (metres along the optical axis; of a scanner the range) has the standard deviation sigma_z(z):
polynomial (Eq. 22 of the paper) k1 z^2 + k2 z + k3, or axial sqrt(a^2 + (b z^2)^2), a floor and the growth of a
triangulating sensor. Real errors come in blotches: correlation_length is their Gaussian radius in pixels. Where none is
given, it is measured on the frames. InputError for values that cannot be used.)")
      .def_static(
          "polynomial",
          [](double k1, double k2, double k3, double length) {
            return usable(SensorModel::polynomial(k1, k2, k3, length));
          },
          "k1"_a, "k2"_a, "k3"_a, "correlation_length"_a = 1.0,
          "Eq. 22: sigma_z = k1 z^2 + k2 z + k3 (1/m, no unit, m); correlation length in pixels.")
      .def_static(
          "axial", [](double a, double b, double length) { return usable(SensorModel::axial(a, b, length)); }, "a"_a,
          "b"_a, "correlation_length"_a = 1.0,
          "sigma_z^2 = a^2 + (b z^2)^2, a in metres, b in 1/m; correlation length in pixels.")
      .def_static("preset", &preset, "name"_a, "A named sensor, one of preset_names(). InputError for any other name.")
      .def_static("preset_names", &SensorModel::presetNames, "The names of the presets.")
      .def_static("parse", &parsed, "text"_a,
                  R"(Reads "PRESET", "A,B,L", "A,B,L,C" or "poly:K1,K2,K3" (metres, 1/m, pixels).

The form of the command line's --noise. InputError, with what is wrong in words, for any other text.)")
      .def("sigma_z", py::vectorize(&whereKnown<&SensorModel::sigmaZ>), "z"_a,
           "Standard deviation in metres of depths of z metres, a number or an array; never below a micrometre, NaN of "
           "NaN.")
      .def("variance_z", py::vectorize(&whereKnown<&SensorModel::varianceZ>), "z"_a, "sigma_z squared, m^2.")
      .def("sigma_inverse_depth", py::vectorize(&whereKnown<&SensorModel::sigmaInverseDepth>), "z"_a,
           "Standard deviation of the inverse depth, sigma_z / z^2, in 1/m.")
      .def_property_readonly("is_polynomial", &SensorModel::isPolynomial, "True for the form of Eq. 22.")
      .def_property_readonly(
          "coefficients", [](const SensorModel& m) { return py::tuple(py::cast(m.coefficients())); },
          "(k1, k2, k3) of the polynomial form, (a, b, 0) of the axial one.")
      .def_property_readonly("correlation_length", &SensorModel::correlationLength,
                             "Radius l of the error's autocorrelation exp(-r^2 / (2 l^2)), pixels.")
      .def_property_readonly("correlated_share", &SensorModel::correlatedShare,
                             "Share of sigma_z squared in which whole surfaces err together, by blotches and by "
                             "bending: 0 (white error on perfect optics) to 1, the default, also if not known.")
      .def_property_readonly("pixels_per_sample", &SensorModel::pixelsPerSample,
                             "Pixels per independent sample over an area, max(1, 2 pi l^2).")
      .def_property_readonly("pixels_per_line_sample", &SensorModel::pixelsPerLineSample,
                             "Pixels per independent sample along a line, max(1, 2.5 l).")
      .def(
          "with_correlation_length", [](const SensorModel& m, double l) { return usable(m.withCorrelationLength(l)); },
          "length"_a, "The same error with another correlation length, pixels.")
      .def(
          "with_correlated_share", [](const SensorModel& m, double c) { return usable(m.withCorrelatedShare(c)); },
          "share"_a, "The same error with another correlated share, 0 to 1.")
      .def(
          "scaled", [](const SensorModel& m, double factor) { return usable(m.scaled(factor)); }, "factor"_a,
          "The error `factor` times as large, with the same correlation length.")
      .def_property_readonly("description", &SensorModel::description,
                             "One line for reports, as \"axial a=0.0035 m b=0.0055 1/m l=9.5 px\".")
      .def("__eq__",
           [](const SensorModel& a, const py::object& b) {
             return py::isinstance<SensorModel>(b) && values(a).equal(values(b.cast<SensorModel>()));
           })
      .def("__repr__", [](const SensorModel& m) { return "<epcc.SensorModel " + m.description() + ">"; })
      .def(py::pickle(&values, &fromValues));
}

}  // namespace epcc::python
