// SPDX-License-Identifier: BSD-3-Clause
// One line on the terminal: how far, how fast, how long still.
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

namespace epcc {

/// "12/300 frames, 4.1 per second, 1:10 left", or hours as "2:03:15 left".
std::string progressText(std::size_t done, std::size_t total, double seconds);

/// Rewrites its line on `err`; silent where `on` is false, as in a log.
class EvalProgress {
 public:
  EvalProgress(std::size_t total, std::ostream& err, bool on);
  void show(std::size_t done);
  /// Takes the line away, before something else is written.
  void clear();

 private:
  std::size_t total_;
  std::ostream& err_;
  bool on_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace epcc
