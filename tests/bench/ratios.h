// SPDX-License-Identifier: BSD-3-Clause
// Collects the times of the cases while Google Benchmark reports them, and compares them in a table.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace epcc::bench {

/// Milliseconds of the cases: by place (a size, or "frames" for all of a folder), then by METHOD or METHOD/VARIANT; one
/// value a frame or repetition.
using CaseTimes = std::map<std::string, std::map<std::string, std::vector<double>>>;

/// Passes everything on to another reporter and keeps the times.
class CollectingReporter : public benchmark::BenchmarkReporter {
 public:
  explicit CollectingReporter(benchmark::BenchmarkReporter& reporter) : reporter_(reporter) {}
  bool ReportContext(const Context& context) override { return reporter_.ReportContext(context); }
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override { reporter_.Finalize(); }
  const CaseTimes& times() const { return times_; }

 private:
  benchmark::BenchmarkReporter& reporter_;
  CaseTimes times_;
};

/// A line a pair of methods, a column a place; pairs and places that were not timed are left out. Of frames of a folder
/// the medians are compared, and printed.
void printRatios(const CaseTimes& times, std::ostream& out);

}  // namespace epcc::bench
