// SPDX-License-Identifier: BSD-3-Clause
// One input after the other is read, segmented, written and reported; one that fails does not keep the others back.
#include "eval/segment/segment_command.h"

#include <algorithm>
#include <cstdio>
#include <new>
#include <ostream>
#include <sstream>
#include <vector>

#include "datasets/support/input_error.h"
#include "datasets/support/output_folder.h"
#include "epcc_segmentation/plane_extractor.h"
#include "eval/program/command_line.h"
#include "eval/program/frame_sensor.h"
#include "eval/program/lap_time.h"
#include "eval/program/progress_line.h"
#include "eval/segment/frame_planes.h"
#include "eval/segment/plane_report.h"
#include "eval/segment/segment_input.h"
#include "eval/segment/segment_output.h"

namespace epcc {
namespace {

constexpr const char* kProgram = "epcc_segment";

/// What the steps around the segmentation take.
struct StepTimes {
  double reading = 0.0;
  double sensor = 0.0;  ///< choosing the sensor model, or measuring it
  double writing = 0.0;
};

std::string heading(const SegmentInput& input, const LabelledFrame& frame, const PlaneSegmentation& result,
                    const FrameSensor& sensor) {
  const auto valid = std::count_if(frame.depth.data.begin(), frame.depth.data.end(), [](float z) { return z > 0.0F; });
  const auto labelled = std::count_if(result.labels.begin(), result.labels.end(), [](std::int32_t k) { return k > 0; });
  const double share = valid > 0 ? 100.0 * static_cast<double>(labelled) / static_cast<double>(valid) : 0.0;
  const char* word = result.planes.size() == 1 ? "plane" : "planes";
  char text[160];
  if (valid == 0) {
    std::snprintf(text, sizeof text, ": %dx%d, 0 planes: no pixel is measured\n", frame.depth.width,
                  frame.depth.height);
    return input.path + text;
  }
  std::snprintf(text, sizeof text, ": %dx%d, %zu %s on %.1f %% of the measured pixels, noise ", frame.depth.width,
                frame.depth.height, result.planes.size(), word, share);
  return input.path + text + sensor.name + '\n';
}

std::string timingLine(const StepTimes& steps, const StageTimes& stages) {
  char text[240];
  std::snprintf(text, sizeof text,
                "  time: reading %.1f ms, sensor %.1f ms, segmentation %.1f ms (read %.1f, lines %.1f, planes %.1f, "
                "regions %.1f, result %.1f), writing %.1f ms\n",
                steps.reading, steps.sensor, 1e3 * stages.total(), 1e3 * stages.read, 1e3 * stages.lines,
                1e3 * stages.planes, 1e3 * stages.regions, 1e3 * stages.result, steps.writing);
  return text;
}

/// One input from file to files; returns its report. Throws InputError, OutputError. What a person should know goes to
/// `notes`, one line each.
std::string segmentOne(const SegmentOptions& options, const SegmentInput& input, PlaneExtractor& extractor,
                       std::ostream& notes) {
  if (input.problem) throw *input.problem;
  StepTimes times;
  Clock::time_point start = Clock::now();
  const LabelledFrame frame = loadInput(input, options);
  times.reading = lapMs(start);
  if (!frame.scan.empty() && frame.geometry.unit_is_guessed)
    notes
        << kProgram << ": " << input.path
        << ": unit: taken as millimetres, for as metres the points would be too far away; --unit m, cm or mm says it\n";

  const FrameSensor sensor = sensorOf(input, frame, options.noise);
  times.sensor = lapMs(start);
  PlaneSegmentation result;
  findPlanes(input, frame, sensor, options.parameters, extractor, result);
  if (result.doubts.any()) notes << kProgram << ": " << input.path << ": " << result.doubts.inWords() << '\n';

  start = Clock::now();
  writeOutputs(outputPaths(options, input), frame, result, {extractor.sensor(), options.mesh_is_text});
  times.writing = lapMs(start);

  std::string report = heading(input, frame, result, sensor);
  if (!result.planes.empty()) report += planeTable(summarizePlanes(frameView(frame), result), "  ");
  if (options.timing) report += timingLine(times, extractor.times());
  return report;
}

/// All inputs, whatever becomes of each; the worst exit code.
int segmentAll(const SegmentOptions& options, const std::vector<SegmentInput>& inputs, std::ostream& out,
               std::ostream& err) {
  ProgressLine progress(err);
  PlaneExtractor extractor(options.parameters);  // keeps its memory from frame to frame
  int code = kExitDone;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (inputs.size() > 1) progress.show(i, inputs.size());
    std::string report;
    std::ostringstream problem;
    const int of_frame = runStep(kProgram, problem, [&] {
      try {
        report = segmentOne(options, inputs[i], extractor, problem);
      } catch (const std::bad_alloc&) {
        throw InputError(inputs[i].path, "size", "does not fit into memory");
      }
      return kExitDone;
    });
    progress.clear();
    out << report;
    err << problem.str();
    code = std::max(code, of_frame);
  }
  return code;
}

}  // namespace

int runSegment(const SegmentOptions& options, std::ostream& out, std::ostream& err) {
  return runProgram(kProgram, out, err, [&]() -> int {
    const InputList list = listInputs(options);
    std::string misuse = list.usage_problem;
    if (misuse.empty() && list.several && options.namesOutputs()) misuse = kOneInputOnly;
    if (misuse.empty()) misuse = checkOutputs(options, list.inputs);
    if (!misuse.empty()) return reportProblem(kProgram, err, misuse, kExitUsage);
    if (!options.out.empty()) makeOutputFolder(options.out);
    return segmentAll(options, list.inputs, out, err);
  });
}

int segmentMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  SegmentOptions options;
  const std::optional<int> done = parseSegmentOptions(argc, argv, options, out, err);
  return done ? *done : runSegment(options, out, err);
}

}  // namespace epcc
