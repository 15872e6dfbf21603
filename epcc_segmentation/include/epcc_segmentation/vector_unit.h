// SPDX-License-Identifier: BSD-3-Clause
// The processor's vector unit that the inner loops run on. The labels are the same on each.
#pragma once

#include <string>
#include <vector>

#include "epcc_segmentation/export.h"

namespace epcc {

/// The units that this processor has and the library was built for, the fastest first: of `avx512`, `avx2`, `sse4`,
/// `ssse3` and `sse2` on x86-64, `neon` on arm64. `sse2` is the fallback for processors before 2006 and has no vectors
/// of its own: what the compiler makes of plain loops.
EPCC_CORE_EXPORT std::vector<std::string> vectorUnits();

/// The one in use: the fastest, or the one that the environment variable EPCC_VECTOR_UNIT named when the process began.
EPCC_CORE_EXPORT std::string vectorUnit();

/// Uses another one from now on, in the whole process; meant for tests and measurements. False, and nothing changes, if
/// the processor has none of that name.
EPCC_CORE_EXPORT bool setVectorUnit(const std::string& name);

/// Empty, or what is wrong with EPCC_VECTOR_UNIT, in words.
EPCC_CORE_EXPORT std::string vectorUnitProblem();

}  // namespace epcc
