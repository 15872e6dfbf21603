// SPDX-License-Identifier: BSD-3-Clause
// One of several equal parts of a run.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace epcc {

/// Part I of N, I from 1: every N-th frame from the I-th on, so that the parts take about the same time.
struct Shard {
  std::size_t number = 1;
  std::size_t count = 1;

  bool holds(std::size_t position) const { return position % count == number - 1; }
  std::string text() const { return std::to_string(number) + "/" + std::to_string(count); }
};

/// "I/N" with 1 <= I <= N <= 1000000; nothing for another text.
std::optional<Shard> parseShard(const std::string& text);

}  // namespace epcc
