// SPDX-License-Identifier: BSD-3-Clause
// Splits a range, of scan lines mostly, over threads.
#pragma once

#include <algorithm>
#include <thread>
#include <vector>

namespace epcc {

/// Calls work(thread, begin, end) for `threads` consecutive parts of [0, count). Each part's results must go to
/// places of its own: then nothing depends on the number of threads.
template <typename Work>
void parallelFor(int count, int threads, const Work& work) {
  threads = std::max(1, std::min(threads, count));
  std::vector<std::thread> others;
  others.reserve(static_cast<std::size_t>(threads - 1));
  const auto bound = [&](int part) { return static_cast<int>(static_cast<long>(count) * part / threads); };
  for (int part = 1; part < threads; ++part)
    others.emplace_back([&work, &bound, part] { work(part, bound(part), bound(part + 1)); });
  work(0, 0, bound(1));
  for (auto& other : others) other.join();
}

}  // namespace epcc
