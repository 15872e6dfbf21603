// SPDX-License-Identifier: BSD-3-Clause
// One log after the other; one that cannot be used does not keep the others back.
#include "eval/lines/lines_command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <ostream>
#include <set>
#include <utility>

#include "datasets/files/laser_log.h"
#include "datasets/files/png_io.h"
#include "datasets/support/atomic_file.h"
#include "datasets/support/file_place.h"
#include "datasets/support/input_error.h"
#include "datasets/support/output_folder.h"
#include "datasets/support/quantile.h"
#include "epcc_segmentation/range_noise.h"
#include "eval/lines/line_list.h"
#include "eval/lines/line_map.h"
#include "eval/lines/lines_options.h"
#include "eval/program/command_line.h"

namespace epcc {
namespace {

constexpr const char* kProgram = "epcc_lines";
constexpr double kDoubtfulError = 0.25;  // m; range finders have a few centimetres

/// The file's name without folder and the endings of logs.
std::string nameOf(const std::string& log) {
  std::string name = std::filesystem::path(log).filename().string();
  for (const char* ending : {".gz", ".log", ".clf", ".csv"}) {
    const std::string text = ending;
    if (name.size() > text.size() && name.compare(name.size() - text.size(), text.size(), text) == 0)
      name.resize(name.size() - text.size());
  }
  return name;
}

constexpr const char* kOutputs[] = {"_lines.csv", "_scan.png", "_scan.svg", "_map.png", "_map.svg"};

/// Why outputs would take the place of each other or of logs; empty if they do not.
std::string outputProblem(const LinesOptions& options) {
  std::set<std::string> names;
  std::set<std::filesystem::path> logs;
  for (const std::string& log : options.logs) {
    if (!names.insert(nameOf(log)).second)
      return "two logs are named " + nameOf(log) + ": their outputs would be the same";
    logs.insert(filePlace(log));
  }
  for (const std::string& name : names)
    for (const char* ending : kOutputs)
      if (logs.count(filePlace(options.out + "/" + name + ending)) != 0)
        return options.out + "/" + name + ending + " would overwrite a log";
  return {};
}

std::size_t countReturns(const LaserScan& scan) {
  std::size_t returns = 0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) returns += scan.hasReturn(i);
  return returns;
}

std::size_t scanToDraw(const LaserLog& log, const LinesOptions& options, const std::string& path) {
  if (options.scan) {
    if (static_cast<std::size_t>(*options.scan) >= log.records.size())
      throw InputError(path, "--scan", "there are " + std::to_string(log.records.size()) + " scans, from 0");
    return static_cast<std::size_t>(*options.scan);
  }
  const auto fewer = [](const LaserRecord& a, const LaserRecord& b) {
    return countReturns(a.scan) < countReturns(b.scan);
  };
  return static_cast<std::size_t>(std::max_element(log.records.begin(), log.records.end(), fewer) -
                                  log.records.begin());
}

/// A few hundred scans, evenly spread, tell as much as all.
std::size_t sampleStep(const LaserLog& log) {
  return std::max<std::size_t>(1, log.records.size() / 500);
}

/// sigma_r = a + b r: given, or measured on the log.
RangeNoiseEstimate noiseOf(const LaserLog& log, const LinesOptions& options, std::string& text) {
  char buffer[160];
  RangeNoiseEstimate noise;
  if (options.noise) {
    noise.a = options.noise->coefficients()[2];
    noise.b = options.noise->coefficients()[1];
  } else {
    std::vector<LaserScan> scans;
    for (std::size_t i = 0; i < log.records.size(); i += sampleStep(log)) scans.push_back(log.records[i].scan);
    noise = estimateRangeNoise(scans);
  }
  std::snprintf(buffer, sizeof buffer, "sigma_r = %.4f m + %.5f r, %s", noise.a, noise.b,
                options.noise        ? "given"
                : noise.windows == 0 ? "generic, for nothing straight was there to measure"
                                     : "measured");
  text = buffer;
  return noise;
}

std::size_t linesIn(const LogLines& lines) {
  std::size_t count = 0;
  for (const LaserLines& scan : lines.scans) count += scan.lines.size();
  return count;
}

double medianRange(const LaserLog& log) {
  std::vector<double> ranges;
  for (std::size_t k = 0; k < log.records.size(); k += sampleStep(log)) {
    const LaserScan& scan = log.records[k].scan;
    for (std::size_t i = 0; i < scan.ranges.size(); ++i)
      if (scan.hasReturn(i)) ranges.push_back(scan.ranges[i]);
  }
  return ranges.empty() ? 0.0 : median(std::move(ranges));
}

/// What makes the lines doubtful although nothing failed; empty if nothing does.
std::string doubtsAbout(const LaserLog& log, const LogLines& lines, const RangeNoiseEstimate& noise, bool is_given) {
  if (std::none_of(log.records.begin(), log.records.end(), [](const auto& r) { return countReturns(r.scan) > 0; }))
    return "no beam has a return: are the ranges in metres?";
  const double error = noise.a + noise.b * medianRange(log);
  char text[160];
  std::snprintf(text, sizeof text,
                "noise: the measured error is %.2f m, more than that of a range finder: are the ranges in metres?",
                error);
  if (!is_given && noise.windows > 0 && error >= kDoubtfulError) return text;
  return linesIn(lines) == 0 ? "no line was found: are the ranges in metres and the angles in radians?" : "";
}

void writeMap(const std::string& path, const LineMap& map) {
  writeRgb(path + ".png", drawMap(map));
  writeTextFile(path + ".svg", mapSvg(map));
}

std::string summary(const std::string& name, const LaserLog& log, const LogLines& lines, const std::string& noise) {
  std::size_t returns = 0, taken = 0;
  const std::size_t count = linesIn(lines);
  for (const LaserRecord& record : log.records) returns += countReturns(record.scan);
  for (const LaserLines& scan : lines.scans)
    for (const LaserLine& line : scan.lines) taken += static_cast<std::size_t>(line.points);
  const auto scans = static_cast<double>(log.records.size());
  char text[400];
  std::snprintf(text, sizeof text,
                "%s: %zu %s, %zu returns, %s\n  %zu lines, %.1f a scan, with %.1f %% of the returns\n",
                printable(name).c_str(), log.records.size(), log.records.size() == 1 ? "scan" : "scans", returns,
                noise.c_str(), count, static_cast<double>(count) / scans,
                100.0 * static_cast<double>(taken) / static_cast<double>(std::max<std::size_t>(1, returns)));
  return text;
}

/// Reads, finds, writes; kExitInput if a part of the log could not be used.
int doLog(const std::string& path, const LinesOptions& options, std::ostream& out, std::ostream& err) {
  LaserLog log = readLaserLog(path);
  for (const std::string& problem : log.problems) reportProblem(kProgram, err, problem, kExitInput);
  if (log.more_problems > 0)
    reportProblem(kProgram, err, path + ": " + std::to_string(log.more_problems) + " more lines", kExitInput);
  if (options.max_range)
    for (LaserRecord& record : log.records) record.scan.range_max = *options.max_range;

  const std::size_t drawn = scanToDraw(log, options, path);
  std::string noise_text;
  const RangeNoiseEstimate noise = noiseOf(log, options, noise_text);
  const LogLines lines = findLines(log, noise.model(), options.parameters, threadsFor(options.jobs));
  const std::string doubts = doubtsAbout(log, lines, noise, options.noise.has_value());
  if (!doubts.empty()) err << kProgram << ": " << printable(path) << ": " << doubts << '\n';

  const std::string name = nameOf(path), start = options.out + "/" + name;
  writeTextFile(start + "_lines.csv", lineListCsv(log, lines));
  writeMap(start + "_scan", scanMap(log.records[drawn], lines.scans[drawn], name + ", scan " + std::to_string(drawn)));
  const bool posed =
      std::any_of(log.records.begin(), log.records.end(), [](const auto& r) { return r.pose.has_value(); });
  if (posed) writeMap(start + "_map", logMap(log, lines, name));

  out << summary(name, log, lines, noise_text);
  if (options.timing) {
    char text[80];
    const double scans = static_cast<double>(log.records.size());
    std::snprintf(text, sizeof text, "  %.3f ms a scan\n", 1e3 * lines.seconds / scans);
    out << text;
  }
  return log.problems.empty() ? kExitDone : kExitInput;
}

}  // namespace

int linesMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  LinesOptions options;
  if (const auto done = parseLinesOptions(argc, argv, options, out, err)) return *done;
  return runProgram(kProgram, out, err, [&]() -> int {
    const std::string misuse = outputProblem(options);
    if (!misuse.empty()) return reportProblem(kProgram, err, misuse, kExitUsage);
    makeOutputFolder(options.out);
    int code = kExitDone;
    for (const std::string& log : options.logs)
      code = std::max(code, runStep(kProgram, err, [&] { return doLog(log, options, out, err); }));
    return code;
  });
}

}  // namespace epcc
