// SPDX-License-Identifier: BSD-3-Clause
// Runs work on several threads at once; what it throws reaches the caller.
#pragma once

#include <functional>

#include "epcc_segmentation/export.h"

namespace epcc {

/// Calls work() on `threads` threads, the caller's among them, and returns when every call has ended. Then rethrows the
/// first exception that a call threw. Where the system refuses to start a thread, fewer calls are made, at least one:
/// the calls must share what is to be done, for example by an atomic counter.
EPCC_CORE_EXPORT void onThreads(int threads, const std::function<void()>& work);

}  // namespace epcc
