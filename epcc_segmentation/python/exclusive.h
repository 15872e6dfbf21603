// SPDX-License-Identifier: BSD-3-Clause
// Objects of the library that serve one thread at a time, safe to share between Python's threads.
#pragma once

#include <pybind11/pybind11.h>

#include <mutex>
#include <utility>

namespace epcc::python {

/// Holds a T. run() lets other Python threads go on meanwhile, and lets one thread in at a time.
template <typename T>
class Exclusive {
 public:
  template <typename... Arguments>
  explicit Exclusive(Arguments&&... arguments) : value_(std::forward<Arguments>(arguments)...) {}

  /// work(value) without the GIL: it must touch nothing of Python's.
  template <typename Work>
  auto run(const Work& work) {
    const pybind11::gil_scoped_release released;  // before the lock: who holds the lock may wait for the GIL
    const std::lock_guard<std::mutex> lock(mutex_);
    return work(value_);
  }

 private:
  T value_;
  std::mutex mutex_;
};

}  // namespace epcc::python
