// SPDX-License-Identifier: BSD-3-Clause
// Splits a range, of scan lines mostly, over threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>

#include "worker_pool.h"

namespace epcc {

/// Calls work(part, begin, end) for `threads` consecutive parts of [0, count), each on a thread of its own where the
/// system has as many, and rethrows the first exception after all have ended. Each part's results must go to places of
/// its own: then nothing depends on the number of threads.
template <typename Work>
void parallelFor(int count, int threads, const Work& work) {
  const int parts = std::max(1, std::min(threads, count));
  const auto bound = [&](int part) { return static_cast<int>(static_cast<long>(count) * part / parts); };
  std::atomic<int> next{0};
  const auto take = [&] {
    for (int part = next++; part < parts; part = next++) work(part, bound(part), bound(part + 1));
  };
  onWorkers(parts, std::ref(take));  // a function object of its own would be allocated
}

/// The same for work whose parts take unlike times: calls work(thread, begin, end) for several parts per thread, and
/// who has done one takes the next. `thread` says whose memory a call may use; no call may depend on those before it.
template <typename Work>
void sharedFor(int count, int threads, const Work& work) {
  constexpr int kPartsPerThread = 8;
  const int sharers = std::max(1, std::min(threads, count));
  const int parts = sharers == 1 ? 1 : std::min(kPartsPerThread * sharers, count);
  const auto bound = [&](int part) { return static_cast<int>(static_cast<long>(count) * part / parts); };
  std::atomic<int> next_thread{0};
  std::atomic<int> next_part{0};
  const auto take = [&] {
    const int thread = next_thread++;
    for (int part = next_part++; part < parts; part = next_part++) work(thread, bound(part), bound(part + 1));
  };
  onWorkers(sharers, std::ref(take));
}

}  // namespace epcc
