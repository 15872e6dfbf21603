// SPDX-License-Identifier: BSD-3-Clause
// The table of ratios below Google Benchmark's output.
#include "tests/bench/ratios.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "datasets/support/quantile.h"

namespace epcc::bench {

namespace {

const char kFolder[] = "frames";

/// How many times the one takes the time of the other.
struct Ratio {
  const char* what;
  const char* over;
  const char* under;
};

constexpr Ratio kRatios[] = {
    {"PCL organized multi-plane / default", "PclOrganizedMultiPlane", "Default"},
    {"PCL region growing / default", "PclRegionGrowing", "Default"},
    {"PCL RANSAC / default", "PclRansac", "Default"},
    {"default / default, 2 threads", "Default", "Default/threads:2"},
    {"paper / paper, 2 threads", "Paper", "Paper/threads:2"},
    {"paper / default", "Paper", "Default"},
    {"auto, single frame / default", "Auto", "Default"},
    {"auto, settled / default", "AutoStream", "Default"},
    {"PCL class / default", "PclClass", "Default"},
    {"16-bit depths / default", "Default/uint16", "Default"},
    {"stride 1 / default", "Default/stride:1", "Default"},
    {"stride 2 / default", "Default/stride:2", "Default"},
    {"stride 3 / default", "Default/stride:3", "Default"},
    {"stride 4 / default", "Default/stride:4", "Default"},
    {"default, AVX2 / default", "Default/unit:avx2", "Default"},
    {"default, SSE4 / default", "Default/unit:sse4", "Default"},
    {"default, SSE2 / default", "Default/unit:sse2", "Default"},
    {"default / read and write", "Default", "Floor"},
    {"default / inverse depths and weights", "Default", "FloorWeights"},
    {"default / statistics of S1", "Default", "FloorStatistics"},
};

/// METHOD/PLACE/VARIANT -> place and METHOD/VARIANT. A frame's own name is forgotten.
struct CaseName {
  std::string place, method;

  explicit CaseName(const std::string& name) {
    std::vector<std::string> parts;
    std::istringstream in(name);
    for (std::string part; std::getline(in, part, '/');) parts.push_back(part);
    method = parts.front();
    if (parts.size() < 2) return;
    place = parts[1];
    const std::size_t rest = place == kFolder ? parts.size() : 2;
    const std::string& last = parts.back();
    if (rest < parts.size() || (place == kFolder && last.rfind("threads:", 0) == 0)) method += "/" + last;
  }
};

/// "640x480" -> its number of pixels; folders come last.
long pixels(const std::string& place) {
  int width = 0, height = 0;
  char x = 0;
  std::istringstream in(place);
  return in >> width >> x >> height ? static_cast<long>(width) * height : -1;
}

/// The median time, or 0 if it was not measured.
double timeOf(const CaseTimes& times, const std::string& place, const std::string& method) {
  const auto& methods = times.at(place);
  const auto found = methods.find(method);
  return found != methods.end() ? median(found->second) : 0.0;
}

std::vector<std::string> placesOf(const CaseTimes& times) {
  std::vector<std::string> places;
  for (const auto& [place, methods] : times)
    if (place == kFolder || pixels(place) > 0) places.push_back(place);
  const auto order = [](const std::string& place) { return place == kFolder ? (1L << 40) : pixels(place); };
  std::sort(places.begin(), places.end(),
            [&](const std::string& a, const std::string& b) { return order(a) < order(b); });
  return places;
}

void printMedians(const CaseTimes& times, std::ostream& out) {
  const auto folder = times.find(kFolder);
  if (folder == times.end()) return;
  out << "\nMedian over the frames, ms\n";
  for (const auto& [method, values] : folder->second)
    out << "  " << std::left << std::setw(38) << method << std::right << std::setw(10) << std::fixed
        << std::setprecision(2) << median(values) << "  of " << values.size() << " runs\n";
}

}  // namespace

void CollectingReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.error_occurred || run.run_type != Run::RT_Iteration) continue;
    const CaseName name(run.benchmark_name());
    times_[name.place][name.method].push_back(run.GetAdjustedRealTime());  // in the unit of the case, milliseconds
  }
  reporter_.ReportRuns(runs);
}

void printRatios(const CaseTimes& times, std::ostream& out) {
  const std::vector<std::string> places = placesOf(times);
  std::ostringstream table;
  for (const Ratio& ratio : kRatios) {
    std::ostringstream line;
    line << std::left << std::setw(40) << ratio.what << std::right << std::fixed << std::setprecision(2);
    bool measured = false;
    for (const std::string& place : places) {
      const double over = timeOf(times, place, ratio.over), under = timeOf(times, place, ratio.under);
      const bool both = over > 0.0 && under > 0.0;
      if (both)
        line << std::setw(11) << over / under;
      else
        line << std::setw(11) << "";
      measured = measured || both;
    }
    if (measured) table << line.str() << '\n';
  }
  if (!table.str().empty()) {
    out << "\n" << std::left << std::setw(40) << "Ratios of the times" << std::right;
    for (const std::string& place : places) out << std::setw(11) << place;
    out << '\n' << table.str();
  }
  printMedians(times, out);
}

}  // namespace epcc::bench
