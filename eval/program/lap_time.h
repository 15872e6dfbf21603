// SPDX-License-Identifier: BSD-3-Clause
// What the steps of a program take.
#pragma once

#include <chrono>

namespace epcc {

using Clock = std::chrono::steady_clock;

/// Milliseconds since `start`, which then starts anew.
inline double lapMs(Clock::time_point& start) {
  const Clock::time_point now = Clock::now();
  const double ms = 1e3 * std::chrono::duration<double>(now - start).count();
  start = now;
  return ms;
}

}  // namespace epcc
