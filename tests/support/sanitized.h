// SPDX-License-Identifier: BSD-3-Clause
// What a sanitizer, under which all takes ten times as long, need not see again.
#pragma once

namespace epcc::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

/// How often a test repeats what differs by its seed alone: a sanitizer watches which code runs, not how results are
/// spread.
constexpr int repeats(int times) {
  return kIsSanitized ? (times + 9) / 10 : times;
}

}  // namespace epcc::test
