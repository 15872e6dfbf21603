// SPDX-License-Identifier: BSD-3-Clause
// Reads, segments, writes and reports one input after the other.
#include "eval/segment/segment_command.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <new>
#include <ostream>

#include "datasets/support/input_error.h"
#include "epcc_segmentation/plane_extractor.h"
#include "eval/program/command_line.h"
#include "eval/program/frame_sensor.h"
#include "eval/segment/plane_report.h"
#include "eval/segment/segment_input.h"
#include "eval/segment/segment_output.h"

namespace epcc {
namespace {

constexpr std::size_t kLongestLine = 1000;

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

int complain(std::ostream& err, const std::string& problem, ExitCode code) {
  err << "epcc_segment: " << printable(problem, kLongestLine) << '\n';
  return code;
}

// "[3/17] name" on a terminal, gone when the input is done.
class Progress {
 public:
  Progress(std::size_t total, std::ostream& err) : total_(total), err_(err), on_(total > 1 && isatty(STDERR_FILENO)) {}
  void show(std::size_t index, const std::string& name) {
    if (on_) err_ << "\r\033[K[" << index + 1 << '/' << total_ << "] " << name << std::flush;
  }
  void clear() {
    if (on_) err_ << "\r\033[K" << std::flush;
  }

 private:
  std::size_t total_;
  std::ostream& err_;
  bool on_;
};

std::string heading(const SegmentInput& input, const LoadedFrame& loaded, const PlaneSegmentation& result,
                    const FrameSensor& sensor) {
  const auto valid =
      std::count_if(loaded.depth.data.begin(), loaded.depth.data.end(), [](float z) { return z > 0.0F; });
  const auto labelled = std::count_if(result.labels.begin(), result.labels.end(), [](std::int32_t k) { return k > 0; });
  const double share = valid > 0 ? 100.0 * static_cast<double>(labelled) / static_cast<double>(valid) : 0.0;
  const char* word = result.planes.size() == 1 ? "plane" : "planes";
  char text[160];
  std::snprintf(text, sizeof text, ": %dx%d, %zu %s on %.1f %% of the measured pixels, noise ", loaded.width,
                loaded.height, result.planes.size(), word, share);
  return input.path + text + sensor.name + '\n';
}

std::string timingLine(double reading, const StageTimes& times, double writing) {
  char text[240];
  std::snprintf(text, sizeof text,
                "  time: reading %.1f ms, segmentation %.1f ms (read %.1f, lines %.1f, planes %.1f, regions %.1f, "
                "result %.1f), writing %.1f ms\n",
                1e3 * reading, 1e3 * times.total(), 1e3 * times.read, 1e3 * times.lines, 1e3 * times.planes,
                1e3 * times.regions, 1e3 * times.result, 1e3 * writing);
  return text;
}

// One input from file to files; the report is printed last. Throws InputError, OutputError.
std::string segmentOne(const SegmentOptions& options, const SegmentInput& input) {
  if (!input.problem.empty()) throw InputError(input.path, input.problem_field, input.problem);
  Clock::time_point start = Clock::now();
  const LoadedFrame loaded = loadInput(input, options);
  const double reading = secondsSince(start);

  const FrameSensor sensor = frameSensor(options.noise, loaded.noise, loaded.frame(), input.camera_file);
  PlaneExtractor extractor(options.parameters, sensor.model);
  PlaneSegmentation result;
  if (!extractor.extract(loaded.frame(), result)) throw InputError(input.path, "frame", extractor.error());

  start = Clock::now();
  writeOutputs(outputPaths(options, input), loaded, result);
  const double writing = secondsSince(start);

  std::string report = heading(input, loaded, result, sensor);
  if (!result.planes.empty()) report += planeTable(summarizePlanes(loaded.frame(), result), "  ");
  if (options.timing) report += timingLine(reading, extractor.times(), writing);
  return report;
}

// The same with every failure turned into a line and an exit code.
int tryOne(const SegmentOptions& options, const SegmentInput& input, Progress& progress, std::ostream& out,
           std::ostream& err) {
  try {
    const std::string report = segmentOne(options, input);
    progress.clear();
    out << report;
    return kExitDone;
  } catch (const InputError& error) {
    progress.clear();
    return complain(err, error.what(), kExitInput);
  } catch (const OutputError& error) {
    progress.clear();
    return complain(err, error.what(), kExitOutput);
  } catch (const std::bad_alloc&) {
    progress.clear();
    return complain(err, input.path + ": size: does not fit into memory", kExitInput);
  }
}

// Empty if the folder is there or could be made.
std::string makeOutFolder(const std::string& folder) {
  if (folder.empty()) return folder;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (std::filesystem::is_directory(folder)) return std::string();
  return folder + ": folder: cannot be made" + (error ? ", " + error.message() : std::string());
}

}  // namespace

int runSegment(const SegmentOptions& options, std::ostream& out, std::ostream& err) {
  const InputList list = listInputs(options);
  if (!list.usage_problem.empty()) return complain(err, list.usage_problem, kExitUsage);
  if (list.several && options.namesOutputs()) {
    return complain(err, kOneInputOnly, kExitUsage);
  }
  const std::string clash = checkOutputs(options, list.inputs);
  if (!clash.empty()) return complain(err, clash, kExitUsage);
  const std::string no_folder = makeOutFolder(options.out);
  if (!no_folder.empty()) return complain(err, no_folder, kExitOutput);

  Progress progress(list.inputs.size(), err);
  int code = kExitDone;
  for (std::size_t i = 0; i < list.inputs.size(); ++i) {
    progress.show(i, list.inputs[i].name);
    code = std::max(code, tryOne(options, list.inputs[i], progress, out, err));
  }
  out.flush();
  if (!out) return complain(err, "standard output: report: cannot be written", kExitOutput);
  return code;
}

int segmentMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  SegmentOptions options;
  const std::optional<int> done = parseSegmentOptions(argc, argv, options, out, err);
  return done ? *done : runSegment(options, out, err);
}

}  // namespace epcc
