// SPDX-License-Identifier: BSD-3-Clause
// Status and the exceptions: epcc.EpccError and those below it, which are also Python's own kinds of error.
#include "errors.h"

#include "bindings.h"

namespace py = pybind11;

namespace epcc::python {

namespace {

const char* exceptionName(Status status) {
  switch (status) {
    case Status::OutOfMemory:
      return "OutOfMemoryError";
    case Status::Ok:
    case Status::Failed:
      return "EpccError";
    default:
      return "InputError";
  }
}

/// A new class of exceptions in the module.
py::object addException(py::module_& module, const char* name, const char* doc, const py::tuple& bases) {
  py::dict members;
  members["__doc__"] = doc;
  members["__module__"] = module.attr("__name__");
  members["status"] = py::none();
  const py::object type = py::module_::import("builtins").attr("type")(name, bases, members);
  module.attr(name) = type;
  return type;
}

}  // namespace

void throwStatus(Status status, const std::string& text) {
  const py::object type = py::module_::import("epcc._epcc").attr(exceptionName(status));
  const py::object error = type(text);
  error.attr("status") = status;
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

void throwProblem(Status status, const std::string& text) {
  if (!text.empty()) throwStatus(status, text);
}

void throwTypeError(const std::string& text) {
  throw py::type_error(text);
}

void bindErrors(py::module_& module) {
  py::enum_<Status>(module, "Status", "How a segmentation ended: EpccError.status.")
      .value("OK", Status::Ok, "Done; there may be no planes.")
      .value("NO_INPUT", Status::NoInput, "Of the PCL class alone.")
      .value("EMPTY_CLOUD", Status::EmptyCloud, "The cloud or the depth image has no points.")
      .value("SIZE_MISMATCH", Status::SizeMismatch, "Arrays of sizes that do not belong together.")
      .value("UNORGANIZED", Status::Unorganized, "Of the PCL class alone.")
      .value("INVALID_INDICES", Status::InvalidIndices, "Of the PCL class alone.")
      .value("INVALID_CAMERA", Status::InvalidCamera, "The camera or the depth scale is out of its range.")
      .value("INVALID_PARAMETERS", Status::InvalidParameters, "A parameter or the sensor model is out of its range.")
      .value("UNSUPPORTED_SCAN", Status::UnsupportedScan, "Row scan of a spherical scan, whose rows are cones.")
      .value("UNKNOWN_GEOMETRY", Status::UnknownGeometry,
             "Neither a camera nor a scanner sees the cloud's points in the order of its pixels.")
      .value("OUT_OF_MEMORY", Status::OutOfMemory, "There is not enough memory for a frame of this size.")
      .value("FAILED", Status::Failed, "Anything else.")
      .value("OUT_OF_ORDER", Status::OutOfOrder, "Of a stream: a scan line came late or twice; it was left out.");
  const py::module_ builtins = py::module_::import("builtins");
  const py::object error =
      addException(module, "EpccError", "What the library reports; `status` (epcc.Status) says it to a program.",
                   py::make_tuple(builtins.attr("RuntimeError")));
  addException(module, "InputError", "What was given cannot be used: an EpccError and a ValueError.",
               py::make_tuple(error, builtins.attr("ValueError")));
  addException(module, "OutOfMemoryError", "No memory for a frame of this size: an EpccError and a MemoryError.",
               py::make_tuple(error, builtins.attr("MemoryError")));
}

}  // namespace epcc::python
