// SPDX-License-Identifier: BSD-3-Clause
// Lets memory run out at a chosen allocation, and tells how large allocations were.
#pragma once

#include <cstddef>

namespace epcc::test {

/// While it lives, operator new serves `allowed` more allocations, of all threads together, and refuses every one after
/// them. One at a time; programs that use it link failing_allocations.cpp, which replaces the operator.
class FailingAllocations {
 public:
  explicit FailingAllocations(long allowed);
  FailingAllocations(const FailingAllocations&) = delete;
  FailingAllocations& operator=(const FailingAllocations&) = delete;
  ~FailingAllocations();
  /// Whether an allocation was refused.
  bool happened() const;
};

/// Bytes of the largest allocation by operator new since forgetAllocations(), of all threads.
std::size_t largestAllocation();
void forgetAllocations();

}  // namespace epcc::test
