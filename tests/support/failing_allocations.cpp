// SPDX-License-Identifier: BSD-3-Clause
// Replaces operator new by one that counts, and fails when it is told to.
#include "tests/support/failing_allocations.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> limited{false};
std::atomic<long> left{0};
std::atomic<bool> refused{false};
std::atomic<std::size_t> largest{0};

void note(std::size_t size) {
  std::size_t known = largest;
  while (size > known && !largest.compare_exchange_weak(known, size)) {
  }
}

}  // namespace

void* operator new(std::size_t size) {
  if (limited && left-- <= 0) {
    refused = true;
    throw std::bad_alloc();
  }
  note(size);
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

// A sanitizer's own would not match the delete below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}

namespace epcc::test {

FailingAllocations::FailingAllocations(long allowed) {
  refused = false;
  left = allowed;
  limited = true;
}

FailingAllocations::~FailingAllocations() {
  limited = false;
}

bool FailingAllocations::happened() const {
  return refused;
}

std::size_t largestAllocation() {
  return largest;
}

void forgetAllocations() {
  largest = 0;
}

}  // namespace epcc::test
