// SPDX-License-Identifier: BSD-3-Clause
// A block of the heap that the handler of operator new frees.
#include "eval/program/memory_reserve.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace epcc {

namespace {

// So small that it is a part of the heap: what is asked for next is then made of it.
constexpr std::size_t kReservedBytes = 64 * 1024;

std::atomic<void*> reserve{nullptr};

[[noreturn]] void giveBackAndThrow() {
  std::free(reserve.exchange(nullptr));
  throw std::bad_alloc();
}

}  // namespace

void reserveMemory() noexcept {
  if (reserve.load() != nullptr) return;
  std::set_new_handler(giveBackAndThrow);
  std::free(reserve.exchange(std::malloc(kReservedBytes)));  // another thread may have been faster
}

}  // namespace epcc
