// SPDX-License-Identifier: BSD-3-Clause
// Values of parameters from and to Python, and epcc.ParameterField, a row of the table.
#include "parameter_values.h"

#include <pybind11/stl.h>

#include <cstring>

#include "bindings.h"

namespace py = pybind11;

namespace epcc::python {

namespace {

bool isSwitch(const ParameterField& field) {
  return field.choices.size() == 2 && std::strcmp(field.choices[0], "off") == 0;
}

/// "bool", "str", "int" or "float".
const char* typeName(const ParameterField& field) {
  if (isSwitch(field)) return "bool";
  if (!field.choices.empty()) return "str";
  return field.whole ? "int" : "float";
}

[[noreturn]] void throwType(const ParameterField& field, const py::object& value) {
  throwTypeError(std::string(field.name) + " must be " + typeName(field) + ", " + rangeText(field) + ", not " +
                 std::string(py::str(py::type::handle_of(value).attr("__name__"))));
}

bool isBool(const py::object& value) {
  return py::isinstance<py::bool_>(value) || std::strcmp(Py_TYPE(value.ptr())->tp_name, "numpy.bool_") == 0;
}

/// The index of a word; InputError with the library's words for one that is none.
double choiceOf(const ParameterField& field, const py::object& value) {
  const auto word = value.cast<std::string>();
  Parameters parsed;
  throwProblem(Status::InvalidParameters, setParameter(std::string(field.name) + "=" + word, parsed));
  return field.get(parsed);
}

double numberOf(const ParameterField& field, const py::object& value) {
  if (isBool(value) || (field.whole ? !PyIndex_Check(value.ptr()) : !PyNumber_Check(value.ptr())))
    throwType(field, value);
  const double number = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() == nullptr) return number;
  if (PyErr_ExceptionMatches(PyExc_OverflowError) == 0) throw py::error_already_set();
  PyErr_Clear();  // beyond any range
  return std::numeric_limits<double>::infinity();
}

double valueOf(const ParameterField& field, const py::object& value) {
  if (isSwitch(field)) {
    if (!isBool(value)) throwType(field, value);
    return PyObject_IsTrue(value.ptr()) != 0 ? 1.0 : 0.0;
  }
  if (field.choices.empty()) return numberOf(field, value);
  if (!py::isinstance<py::str>(value)) throwType(field, value);
  return choiceOf(field, value);
}

py::object defaultValue(const ParameterField& field) {
  return pythonValue(field, Parameters());
}

}  // namespace

const ParameterField& fieldNamed(const std::string& name) {
  for (const ParameterField& field : parameterFields())
    if (name == field.name) return field;
  throwStatus(Status::InvalidParameters, "there is no parameter '" + name + "'");
}

py::object pythonValue(const ParameterField& field, const Parameters& parameters) {
  const double value = field.get(parameters);
  if (isSwitch(field)) return py::bool_(value != 0.0);
  if (!field.choices.empty()) return py::str(valueText(field, value));
  return field.whole ? py::object(py::int_(static_cast<long>(value))) : py::object(py::float_(value));
}

void setPythonValue(const ParameterField& field, const py::object& value, Parameters& parameters) {
  const double number = valueOf(field, value);
  if (!(number >= field.low && number <= field.high))  // NaN neither
    throwStatus(Status::InvalidParameters,
                std::string(field.name) + " must be in " + rangeText(field) + ", not " + valueText(field, number));
  field.set(parameters, number);
}

std::string fieldDoc(const ParameterField& field) {
  const std::string range = isSwitch(field) ? "False | True" : rangeText(field);
  const std::string start =
      std::string(field.meaning) + ". " + range + ", default " + std::string(py::str(defaultValue(field))) + ". ";
  if (!field.choices.empty()) return start + field.advice + ".";
  return start + "Raise it if " + field.raise + "; lower it if " + field.lower + ".";
}

void bindParameterFields(py::module_& module) {
  py::class_<ParameterField>(module, "ParameterField", "One field of Parameters, a row of the parameter table.")
      .def_readonly("name", &ParameterField::name, "As in C++ and on the command line: inverse_depth.line_k_max.")
      .def_property_readonly("type", &typeName, "\"bool\", \"str\", \"int\" or \"float\".")
      .def_property_readonly("default", &defaultValue, "Its default.")
      .def_property_readonly("range", &rangeText, "\"(0, 100] sigma\" or \"a | b | c | d\".")
      .def_readonly("low", &ParameterField::low, "Smallest value of a number.")
      .def_readonly("high", &ParameterField::high, "Largest value of a number.")
      .def_readonly("choices", &ParameterField::choices, "The words of a choice; empty for a number.")
      .def_readonly("unit", &ParameterField::unit, "Empty for a ratio or a choice.")
      .def_property_readonly("doc", &fieldDoc, "What it is, range, default, and when to change it.")
      .def("__repr__", [](const ParameterField& f) { return "<epcc.ParameterField " + std::string(f.name) + ">"; });
  module.def(
      "parameter_fields", [] { return parameterFields(); }, "All fields of Parameters, in the order of the headers.");
}

}  // namespace epcc::python
