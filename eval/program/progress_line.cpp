// SPDX-License-Identifier: BSD-3-Clause
// The time left is guessed from the rate of the frames done so far.
#include "eval/program/progress_line.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <ostream>

namespace epcc {

std::string progressText(std::size_t done, std::size_t total, double seconds) {
  const std::string count = std::to_string(done) + "/" + std::to_string(total) + " frames";
  if (done == 0 || !(seconds > 0.0)) return count;
  const double rate = static_cast<double>(done) / seconds;
  const long left = std::lround(static_cast<double>(total - done) / rate);
  char text[96];
  if (left >= 3600)
    std::snprintf(text, sizeof text, ", %.3g per second, %ld:%02ld:%02ld left", rate, left / 3600, left / 60 % 60,
                  left % 60);
  else
    std::snprintf(text, sizeof text, ", %.3g per second, %ld:%02ld left", rate, left / 60, left % 60);
  return count + text;
}

ProgressLine::ProgressLine(std::ostream& err) : err_(err), on_(isatty(STDERR_FILENO) != 0) {}

void ProgressLine::show(std::size_t done, std::size_t total) {
  if (!on_) return;
  const auto now = std::chrono::steady_clock::now();
  if (!start_) start_ = now;
  const double seconds = std::chrono::duration<double>(now - *start_).count();
  err_ << "\r\033[K" << progressText(done, total, seconds) << std::flush;
}

void ProgressLine::clear() {
  if (on_ && start_) err_ << "\r\033[K" << std::flush;
}

}  // namespace epcc
