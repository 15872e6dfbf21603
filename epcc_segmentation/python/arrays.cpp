// SPDX-License-Identifier: BSD-3-Clause
// Arrays of other programs: label images, whatever their integers are, and arrays with a mask.
#include "arrays.h"

#include <limits>

#include "errors.h"

namespace py = pybind11;

namespace epcc::python {

void refuseMasked(const py::array& array, const std::string& way_out) {
  if (py::hasattr(array, "mask")) throwTypeError("a masked array is not looked at: fill it, array.filled(0)" + way_out);
}

py::array_t<std::int32_t> labelImage(const py::array& labels) {
  if (labels.ndim() != 2) throwStatus(Status::SizeMismatch, "a label image is H x W, not " + shapeText(labels));
  const char kind = labels.dtype().kind();
  if (kind != 'i' && kind != 'u') throwTypeError("a label image is of integers, not " + typeText(labels));
  if (labels.size() > 0 && (kind == 'u' ? labels.itemsize() >= 4 : labels.itemsize() > 4)) {
    const auto fits = [](const py::object& label) {
      return label >= py::int_(std::numeric_limits<std::int32_t>::min()) &&
             label <= py::int_(std::numeric_limits<std::int32_t>::max());
    };
    if (!fits(labels.attr("min")()) || !fits(labels.attr("max")()))
      throwStatus(Status::InvalidIndices, "a label must fit in 32 bits, from -2^31 to 2^31 - 1");
  }
  const auto rows = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>::ensure(labels);
  if (!rows) throw py::error_already_set();
  return rows;
}

}  // namespace epcc::python
