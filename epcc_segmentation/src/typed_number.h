// SPDX-License-Identifier: BSD-3-Clause
// Numbers that people type, read the same in every locale. (The readers of files have their own,
// datasets/support/number_text.h, for no floor above may look into this folder.)
#pragma once

#include <charconv>
#include <cmath>
#include <string_view>

namespace epcc {

/// The number that the whole word is, which may be infinite and may have spaces and a plus before it; NaN for anything
/// else, also for a word with a zero byte in it.
inline double typedNumber(std::string_view word) {
  while (!word.empty() && word.front() == ' ') word.remove_prefix(1);
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  double value = 0.0;
  const auto parsed = std::from_chars(word.data(), end, value);
  return parsed.ec == std::errc() && parsed.ptr == end ? value : std::nan("");
}

}  // namespace epcc
