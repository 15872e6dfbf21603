// SPDX-License-Identifier: BSD-3-Clause
// The parts of the module epcc, one function each that adds its classes and functions.
#pragma once

#include <pybind11/pybind11.h>

namespace epcc::python {

void bindErrors(pybind11::module_& module);
void bindCamera(pybind11::module_& module);
void bindParameterFields(pybind11::module_& module);
void bindParameters(pybind11::module_& module);
void bindSensorModel(pybind11::module_& module);
void bindCloudGeometry(pybind11::module_& module);
void bindFrame(pybind11::module_& module);
void bindSensorEstimation(pybind11::module_& module);
void bindPlane(pybind11::module_& module);
void bindContours(pybind11::module_& module);
void bindSegmentation(pybind11::module_& module);
void bindExtractor(pybind11::module_& module);
void bindPlaneTracker(pybind11::module_& module);
void bindStreamGeometry(pybind11::module_& module);
void bindScanLineStream(pybind11::module_& module);
void bindVectorUnit(pybind11::module_& module);

}  // namespace epcc::python
