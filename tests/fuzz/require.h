// SPDX-License-Identifier: BSD-3-Clause
// What must hold for any input.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace epcc::fuzz {

/// Ends the process, saying what does not hold: a fuzzer keeps the input then.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "what must hold does not: %s\n", what);
  std::abort();
}

/// Words for people: not empty, one line, nothing that moves a terminal's cursor, not too long.
inline void requireOneLine(const std::string& words) {
  const bool is_plain = std::none_of(words.begin(), words.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  if (words.empty() || !is_plain || words.size() > 2000) std::fprintf(stderr, "\"%s\"\n", words.c_str());
  require(!words.empty(), "an error has words");
  require(is_plain, "an error is one line");
  require(words.size() <= 2000, "an error is short");
}

}  // namespace epcc::fuzz
