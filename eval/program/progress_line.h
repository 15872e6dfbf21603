// SPDX-License-Identifier: BSD-3-Clause
// One line on the terminal: how far, how fast, how long still.
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>

namespace epcc {

/// "12/300 frames, 4.1 per second, 1:10 left", or hours as "2:03:15 left".
std::string progressText(std::size_t done, std::size_t total, double seconds);

/// Rewrites its line on `err`; silent where that is no terminal, as in a log. Nothing is left of it at the end.
class ProgressLine {
 public:
  explicit ProgressLine(std::ostream& err);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { clear(); }
  /// The time counts from the first call.
  void show(std::size_t done, std::size_t total);
  /// Takes the line away, before something else is written.
  void clear();

 private:
  std::ostream& err_;
  bool on_;
  std::optional<std::chrono::steady_clock::time_point> start_;
};

}  // namespace epcc
