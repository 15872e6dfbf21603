// SPDX-License-Identifier: BSD-3-Clause
// numpy arrays that look into the memory of the library's objects.
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace epcc::python {

/// The array, not to be written to, as none is that is read from a result: a view would no longer fit what else is told
/// of the result, and in a copy that is made for each look the change would be lost.
inline pybind11::array readOnly(pybind11::array array) {
  pybind11::detail::array_proxy(array.ptr())->flags &= ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// The vector's values as a read-only array of the given shape, without a copy: `owner` holds the vector and lives on
/// with it.
template <typename T>
pybind11::array viewOf(const std::vector<T>& values, std::vector<pybind11::ssize_t> shape,
                       const pybind11::object& owner, const pybind11::dtype& dtype = pybind11::dtype::of<T>()) {
  static T none;  // an empty vector has no memory, and without memory pybind11 would not look but allocate
  return readOnly(pybind11::array(dtype, std::move(shape), {}, values.empty() ? &none : values.data(), owner));
}

/// "(480, 640, 3)".
inline std::string shapeText(const pybind11::array& array) {
  return pybind11::str(array.attr("shape"));
}

/// The type of its numbers, "float64".
inline std::string typeText(const pybind11::array& array) {
  return pybind11::str(array.dtype());
}

/// TypeError for a numpy.ma array, whose mask would be passed over; `way_out` says what else there is to do.
void refuseMasked(const pybind11::array& array, const std::string& way_out = "");

/// A label image of any program, H x W integers, in rows as int32: the same array where it is that already, else a
/// copy. Throws epcc.InputError for another shape or labels beyond 32 bits and TypeError for numbers that are no
/// integers.
pybind11::array_t<std::int32_t> labelImage(const pybind11::array& labels);

}  // namespace epcc::python
