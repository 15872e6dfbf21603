// SPDX-License-Identifier: BSD-3-Clause
// The processor's vector unit: epcc.vector_units() and its kin.
#include <pybind11/stl.h>

#include "bindings.h"
#include "epcc_segmentation/vector_unit.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

void bindVectorUnit(py::module_& module) {
  module.def("vector_units", &vectorUnits, R"(Vector units that this processor has, the fastest first.

Of "avx512", "avx2", "sse4", "ssse3" and "sse2" on x86-64, "neon" on arm64. Results are the same on each.)");
  module.def("vector_unit", &vectorUnit,
             "The unit in use: the fastest, or what the environment variable EPCC_VECTOR_UNIT named at the start.");
  module.def(
      "set_vector_unit",
      [](const std::string& name) {
        if (!setVectorUnit(name)) throw py::value_error("this processor has no vector unit '" + name + "'");
      },
      "name"_a,
      "Uses another unit from now on, in the whole process; for tests and measurements. ValueError for an unknown "
      "one.");
}

}  // namespace epcc::python
