// SPDX-License-Identifier: BSD-3-Clause
// Fields of the parameter table as Python's values: bool for off | on, str for other choices, int and float.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "epcc_segmentation/parameter_table.h"
#include "errors.h"

namespace epcc::python {

/// Throws epcc.InputError if there is none of that name.
const ParameterField& fieldNamed(const std::string& name);

pybind11::object pythonValue(const ParameterField& field, const Parameters& parameters);

/// Throws epcc.InputError for a value out of its range and TypeError for one of another type; then nothing is changed.
void setPythonValue(const ParameterField& field, const pybind11::object& value, Parameters& parameters);

/// The field's comment in C++, from the table.
std::string fieldDoc(const ParameterField& field);

}  // namespace epcc::python
