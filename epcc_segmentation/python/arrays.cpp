// SPDX-License-Identifier: BSD-3-Clause
// Label images of other programs, whatever their integers are.
#include "arrays.h"

#include "errors.h"

namespace py = pybind11;

namespace epcc::python {

py::array_t<std::int32_t> labelImage(const py::array& labels) {
  if (labels.ndim() != 2) throwStatus(Status::SizeMismatch, "a label image is H x W, not " + shapeText(labels));
  const char kind = labels.dtype().kind();
  if (kind != 'i' && kind != 'u')
    throwTypeError("a label image is of integers, not " + std::string(py::str(labels.dtype())));
  const auto rows = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>::ensure(labels);
  if (!rows) throw py::error_already_set();
  return rows;
}

}  // namespace epcc::python
