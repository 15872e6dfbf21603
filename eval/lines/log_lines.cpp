// SPDX-License-Identifier: BSD-3-Clause
// Every thread takes the next scan.
#include "eval/lines/log_lines.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <stdexcept>

#include "epcc_segmentation/on_threads.h"

namespace epcc {

LogLines findLines(const LaserLog& log, const SensorModel& noise, const LaserLineParameters& parameters, int threads) {
  using Clock = std::chrono::steady_clock;
  LogLines result;
  result.scans.resize(log.records.size());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  onThreads(threads, [&] {
    LaserLineExtractor extractor(noise, parameters);
    const auto start = Clock::now();
    for (std::size_t i = next++; i < log.records.size(); i = next++)
      if (!extractor.extract(log.records[i].scan, result.scans[i]))
        throw std::runtime_error("scan " + std::to_string(i) + ": " + extractor.error());
    const std::chrono::duration<double> taken = Clock::now() - start;
    const std::lock_guard<std::mutex> lock(mutex);
    result.seconds += taken.count();
  });
  return result;
}

}  // namespace epcc
