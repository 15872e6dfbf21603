// SPDX-License-Identifier: BSD-3-Clause
// Calls a kernel's build for the vector unit in use. A kernel is one source that Highway compiles for each unit: it is
// included after hwy/foreach_target.h, exported with HWY_EXPORT and called with EPCC_KERNEL.
#pragma once

#include <hwy/highway.h>

namespace epcc {

/// The units that kernels may use, the one in use alone.
hwy::ChosenTarget& chosenTarget();

}  // namespace epcc

// EPCC_KERNEL(name)(arguments): as HWY_DYNAMIC_DISPATCH, but by this library's choice, not that of all of Highway's
// users in the process.
#if HWY_IDE || ((HWY_TARGETS & (HWY_TARGETS - 1)) == 0)
#define EPCC_KERNEL(NAME) HWY_STATIC_DISPATCH(NAME)
#else
#define EPCC_KERNEL(NAME) (*(HWY_DISPATCH_TABLE(NAME)[epcc::chosenTarget().GetIndex()]))
#endif
