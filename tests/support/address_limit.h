// SPDX-License-Identifier: BSD-3-Clause
// What happens when memory runs out, without a machine that has little.
#pragma once

#include <sys/resource.h>

#include <cstdint>
#include <fstream>

#include "tests/support/sanitized.h"

#define EPCC_NEED_ADDRESS_LIMIT() \
  if (epcc::test::kIsSanitized) GTEST_SKIP() << "a sanitizer needs more address space than the test leaves"

namespace epcc::test {

/// The process may take this much more address space while this lives.
class AddressLimit {
 public:
  explicit AddressLimit(std::uint64_t more) {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    ::getrlimit(RLIMIT_AS, &before_);
    rlimit limit = before_;
    limit.rlim_cur = pages * 4096 + more;
    ok_ = pages > 0 && ::setrlimit(RLIMIT_AS, &limit) == 0;
  }
  AddressLimit(const AddressLimit&) = delete;
  AddressLimit& operator=(const AddressLimit&) = delete;
  ~AddressLimit() { ::setrlimit(RLIMIT_AS, &before_); }
  bool ok() const { return ok_; }

 private:
  rlimit before_{};
  bool ok_ = false;
};

}  // namespace epcc::test
