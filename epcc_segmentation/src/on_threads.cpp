// SPDX-License-Identifier: BSD-3-Clause
// Starts threads, joins them whatever happens, and passes on the first exception.
#include "epcc_segmentation/on_threads.h"

#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace epcc {

void onThreads(int threads, const std::function<void()>& work) {
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto guarded = [&] {
    try {
      work();
    } catch (...) {
      const std::lock_guard<std::mutex> lock(failure_mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  try {
    if (threads > 1) others.reserve(static_cast<std::size_t>(threads - 1));
    for (int i = 1; i < threads; ++i) others.emplace_back(guarded);
  } catch (const std::exception&) {
    // No more threads or no memory for them: those that run do the work.
  }
  guarded();
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace epcc
