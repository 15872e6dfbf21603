// SPDX-License-Identifier: BSD-3-Clause
// Runs a check on every vector unit that the processor has.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "epcc_segmentation/vector_unit.h"

namespace epcc::test {

/// Calls check() with each unit in use in turn, and sets back the one before.
template <typename Check>
void onEveryVectorUnit(const Check& check) {
  const std::string before = vectorUnit();
  for (const std::string& unit : vectorUnits()) {
    SCOPED_TRACE(unit);
    ASSERT_TRUE(setVectorUnit(unit));
    check();
  }
  setVectorUnit(before);
}

}  // namespace epcc::test
