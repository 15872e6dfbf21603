// SPDX-License-Identifier: BSD-3-Clause
// epcc.Parameters and its groups: attributes made from the parameter table, so that every field is there.
#include "epcc_segmentation/parameters.h"

#include <pybind11/stl.h>

#include <map>
#include <memory>

#include "bindings.h"
#include "parameter_values.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

using SharedParameters = std::shared_ptr<Parameters>;

/// A part of the parameters, for example inverse_depth.expert: the attributes are those of its Python class.
struct ParameterGroup {
  SharedParameters parameters;
};

SharedParameters parametersOf(const py::object& owner) {
  if (py::isinstance<ParameterGroup>(owner)) return owner.cast<const ParameterGroup&>().parameters;
  return owner.cast<SharedParameters>();
}

/// "inverse_depth.expert.lines" -> "InverseDepthLines"; "inverse_depth" -> "InverseDepthParameters".
std::string className(const std::string& path) {
  const std::size_t first = path.find('.');
  const std::size_t last = path.rfind('.');
  const std::string words =
      path.substr(0, first) + "_" + (last == std::string::npos ? "parameters" : path.substr(last + 1));
  std::string name;
  bool starts = true;
  for (const char c : words) {
    if (c != '_') name += starts ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    starts = c == '_';
  }
  return name;
}

py::object property(const py::object& get, const py::object& set, const std::string& doc) {
  return py::module_::import("builtins").attr("property")(get, set, py::none(), doc);
}

py::object fieldProperty(const ParameterField& field) {
  const py::cpp_function get([&field](const py::object& owner) { return pythonValue(field, *parametersOf(owner)); });
  const py::cpp_function set([&field](const py::object& owner, const py::object& value) {
    setPythonValue(field, value, *parametersOf(owner));
  });
  return property(get, set, fieldDoc(field));
}

/// Copies what lies under the path.
void copyGroup(const std::string& path, const Parameters& from, Parameters& to) {
  for (const ParameterField& field : parameterFields())
    if (std::string(field.name).rfind(path + ".", 0) == 0) field.set(to, field.get(from));
}

py::object groupProperty(const std::string& path, const py::object& type) {
  const py::cpp_function get([type](const py::object& owner) { return type(parametersOf(owner)); });
  const py::cpp_function set([type, path](const py::object& owner, const py::object& group) {
    if (!py::isinstance(group, type)) throw py::type_error(path + " must be an epcc." + className(path));
    copyGroup(path, *parametersOf(group), *parametersOf(owner));
  });
  return property(get, set, "The parameters " + path + ".*");
}

/// Classes of all groups, and their attributes and those of Parameters.
class Groups {
 public:
  Groups(py::module_& module, const py::object& parameters_class)
      : module_(module), parameters_class_(parameters_class) {
    for (const ParameterField& field : parameterFields()) {
      const std::string path = field.name;
      const std::size_t dot = path.rfind('.');
      const py::object owner = classOf(dot == std::string::npos ? "" : path.substr(0, dot));
      owner.attr(path.substr(dot + 1).c_str()) = fieldProperty(field);
    }
  }

 private:
  /// The class of a path, made and named by its own owner when it is first asked for.
  py::object classOf(const std::string& path) {
    if (path.empty()) return parameters_class_;
    const auto known = classes_.find(path);
    if (known != classes_.end()) return known->second;
    const std::string name = className(path);
    py::dict members;
    members["__doc__"] = "The parameters " + path + ".*, a view on the Parameters it was read from.";
    members["__module__"] = module_.attr("__name__");
    members["__slots__"] = py::tuple();  // a misspelt name is an error
    const py::object type =
        py::module_::import("builtins").attr("type")(name, py::make_tuple(py::type::of<ParameterGroup>()), members);
    module_.attr(name.c_str()) = type;
    classes_[path] = type;
    const std::size_t dot = path.rfind('.');
    const py::object owner = classOf(dot == std::string::npos ? "" : path.substr(0, dot));
    owner.attr(path.substr(dot == std::string::npos ? 0 : dot + 1).c_str()) = groupProperty(path, type);
    return type;
  }

  py::module_& module_;
  py::object parameters_class_;
  std::map<std::string, py::object> classes_;
};

py::dict valuesOf(const Parameters& parameters) {
  py::dict values;
  for (const ParameterField& field : parameterFields()) values[field.name] = pythonValue(field, parameters);
  return values;
}

SharedParameters made(const py::dict& values) {
  auto parameters = std::make_shared<Parameters>();
  for (const auto& [name, value] : values)
    setPythonValue(fieldNamed(name.cast<std::string>()), py::reinterpret_borrow<py::object>(value), *parameters);
  return parameters;
}

SharedParameters copy(const Parameters& parameters) {
  return std::make_shared<Parameters>(parameters);
}

std::string text(const Parameters& parameters) {
  std::string changed;
  for (const ParameterField& field : parameterFields()) {
    const double value = field.get(parameters);
    if (value == field.get(Parameters())) continue;
    changed += (changed.empty() ? ": " : ", ") + std::string(field.name) + "=" + valueText(field, value);
  }
  return "<epcc.Parameters" + changed + ">";
}

}  // namespace

void bindParameters(py::module_& module) {
  bindParameterFields(module);
  py::class_<ParameterGroup>(module, "_ParameterGroup").def(py::init([](const SharedParameters& parameters) {
    return ParameterGroup{parameters};
  }));
  py::class_<Parameters, SharedParameters> type(module, "Parameters",
                                                R"(Everything that steers a segmentation but the sensor.

Attributes are named as in C++ and on the command line, parameters.inverse_depth.line_k_max for example; each has its
unit, range, default and effect in its docstring, and all of them are listed by parameter_fields(). Fields may be given
here: Parameters(threads=4, **{"inverse_depth.stride": 1}). A value out of its range is an InputError, one of the
wrong type a TypeError; a name that does not exist is an AttributeError.)");
  type.def(py::init([](const py::kwargs& fields) { return made(fields); }))
      .def_static(
          "for_paper", [] { return copy(Parameters::forPaper()); },
          "Parameters of the paper mode, Algorithms 1 and 2 as published, with its defaults.")
      .def(
          "set",
          [](Parameters& p, const std::string& assignment) {
            throwProblem(Status::InvalidParameters, setParameter(assignment, p));
          },
          "assignment"_a, "Sets one field from \"NAME=VALUE\"; InputError, and nothing is changed, if it cannot be.")
      .def("as_dict", &valuesOf, "All fields: name -> value.")
      .def(
          "validate", [](const Parameters& p) { throwProblem(Status::InvalidParameters, p.validate()); },
          "InputError, with what is wrong in words, if fields do not fit together.")
      .def("copy", &copy, "An independent copy.")
      .def("__copy__", &copy)
      .def("__deepcopy__", [](const Parameters& p, const py::dict&) { return copy(p); })
      .def("__eq__",
           [](const Parameters& a, const py::object& b) {
             return py::isinstance<Parameters>(b) && valuesOf(a).equal(valuesOf(b.cast<const Parameters&>()));
           })
      .def("__repr__", &text)
      .def(py::pickle(&valuesOf, &made));
  Groups(module, type);
}

}  // namespace epcc::python
