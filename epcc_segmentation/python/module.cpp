// SPDX-License-Identifier: BSD-3-Clause
// The module in C++ behind the Python package epcc.
#include "bindings.h"

namespace py = pybind11;

PYBIND11_MODULE(_epcc, module) {
  using namespace epcc::python;
  // Classes and functions are known as those of the package that shows them: in tracebacks, help() and pickles.
  const py::object name = module.attr("__name__");
  module.attr("__name__") = "epcc";
  module.attr("__version__") = EPCC_VERSION;
  bindErrors(module);
  bindCamera(module);
  bindParameters(module);
  bindSensorModel(module);
  bindCloudGeometry(module);
  bindFrame(module);
  bindSensorEstimation(module);
  bindPlane(module);
  bindContours(module);
  bindSegmentation(module);
  bindExtractor(module);
  bindPlaneTracker(module);
  bindStreamGeometry(module);
  bindScanLineStream(module);
  bindVectorUnit(module);
  module.attr("__name__") = name;
}
