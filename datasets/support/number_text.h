// SPDX-License-Identifier: BSD-3-Clause
// Numbers in text files and on command lines, read the same in every locale.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace epcc {

/// The number that the whole word is, which may be NaN or infinite and may start with a plus; nothing for anything else
/// and for numbers too large or too small for a double.
inline std::optional<double> numberFrom(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  double value = 0.0;
  const auto parsed = std::from_chars(word.data(), end, value);
  if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  return value;
}

/// The whole number from 0 to 2^64 - 1 that the word is, in digits alone; nothing for anything else.
inline std::optional<std::uint64_t> wholeNumberFrom(std::string_view word) {
  const char* const end = word.data() + word.size();
  std::uint64_t value = 0;
  const auto parsed = std::from_chars(word.data(), end, value);
  if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  return value;
}

}  // namespace epcc
