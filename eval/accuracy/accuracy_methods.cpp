// SPDX-License-Identifier: BSD-3-Clause
// Names into methods.
#include "eval/accuracy/accuracy_methods.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "baselines/epcc_segmenter.h"
#include "epcc_segmentation/parameter_table.h"

namespace epcc {

namespace {

Method measuringMethod(const std::string& name, const Parameters& parameters,
                       SensorChoice sensor = SensorChoice::Measured) {
  return {name, [=] { return std::make_unique<EpccSegmenter>(parameters, sensor); }, true};
}

const ParameterField& curveField() {
  for (const ParameterField& field : parameterFields())
    if (std::string(field.name) == accuracyCurve().parameter) return field;
  throw std::logic_error(std::string("there is no parameter ") + accuracyCurve().parameter);
}

}  // namespace

std::vector<std::string> epccMethods() {
  return {kAutoMethod, "epcc", "epcc-paper"};
}

std::vector<std::string> otherMethods() {
  return {"region-growing", "ransac", "omps"};
}

std::vector<std::string> accuracyMethods() {
  std::vector<std::string> methods = epccMethods();
  for (const std::string& name : otherMethods()) methods.push_back(name);
  return methods;
}

Method accuracyMethod(const std::string& name) {
  return name == kAutoMethod ? measuringMethod(name, defaultParameters().epcc) : registeredMethod(name);
}

std::vector<Method> methodsOf(const std::vector<std::string>& names) {
  std::vector<Method> methods;
  for (const std::string& name : names) methods.push_back(accuracyMethod(name));
  return methods;
}

std::vector<Method> sequenceMethods() {
  std::vector<Method> methods = methodsOf(epccMethods());
  methods.front() = measuringMethod(kAutoMethod, defaultParameters().epcc, SensorChoice::MeasuredOnStream);
  return methods;
}

AccuracyCurve accuracyCurve() {
  return {"inverse_depth.min_confidence", {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}};
}

std::string curveText(double value) {
  return valueText(curveField(), value);
}

std::string curveDefault() {
  return curveText(curveField().get(defaultParameters().epcc));
}

std::vector<Method> curveMethods() {
  std::vector<Method> methods;
  for (const double value : accuracyCurve().values) {
    Parameters parameters = defaultParameters().epcc;
    curveField().set(parameters, value);
    methods.push_back(measuringMethod(curveText(value), parameters));
  }
  return methods;
}

}  // namespace epcc
