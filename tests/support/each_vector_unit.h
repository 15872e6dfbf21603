// SPDX-License-Identifier: BSD-3-Clause
// Runs a check on every vector unit that the processor has.
#pragma once

#include <string>

#include "epcc_segmentation/vector_unit.h"

namespace epcc::test {

/// Calls check(name) with each unit in use, then returns to the one before.
template <typename Check>
void forEachVectorUnit(const Check& check) {
  const std::string before = vectorUnit();
  for (const std::string& unit : vectorUnits()) {
    setVectorUnit(unit);
    check(unit);
  }
  setVectorUnit(before);
}

}  // namespace epcc::test
