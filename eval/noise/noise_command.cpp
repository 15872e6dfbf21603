// SPDX-License-Identifier: BSD-3-Clause
// Reads one frame after the other into a pool; one that cannot be used does not keep the others back.
#include "eval/noise/noise_command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <ostream>
#include <sstream>
#include <utility>

#include "datasets/files/camera_json.h"
#include "datasets/files/png_io.h"
#include "datasets/support/atomic_file.h"
#include "datasets/support/file_place.h"
#include "datasets/support/input_error.h"
#include "eval/noise/noise_files.h"
#include "eval/noise/noise_options.h"
#include "eval/program/command_line.h"
#include "eval/program/frame_sensor.h"
#include "eval/program/progress_line.h"
#include "eval/segment/segment_input.h"

namespace epcc {
namespace {

constexpr const char* kProgram = "epcc_noise";

/// What is known of the frames besides what the pool knows.
struct FramesSeen {
  std::optional<LabelledFrame> first;
  std::size_t swapped = 0;  ///< whose bytes are
  std::string first_swapped;
};

void addFrame(const SegmentInput& input, const SegmentOptions& options, SensorPool& pool, FramesSeen& seen) {
  if (input.problem) throw *input.problem;
  LabelledFrame frame = loadInput(input, options);
  const DepthFrame view = frameView(frame);
  if (view.empty()) throw InputError(input.path, "frame", view.problem());
  if (!pool.add(view))
    throw InputError(input.path, "size",
                     "is not that of the frames before it, or its pixels are scattered unlike theirs");
  if (frame.bytes_are_swapped && ++seen.swapped == 1) seen.first_swapped = input.path;
  if (!seen.first) seen.first = std::move(frame);
}

/// What makes the measured error doubtful; empty if nothing does.
std::string doubtsAbout(const FramesSeen& seen, const SensorEstimate& estimate) {
  if (seen.swapped > 0) {
    Doubts doubts;
    doubts.bytes_are_swapped = true;
    return doubtfulText(seen.swapped, seen.first_swapped, doubts.inWords());
  }
  const Doubts doubts = Doubts::of(frameView(*seen.first), estimate);
  return doubts.any() ? seen.first->name + ": " + doubts.inWords() : std::string();
}

/// All frames, whatever becomes of each; the worst exit code.
int addFrames(const std::vector<SegmentInput>& inputs, const SegmentOptions& options, SensorPool& pool,
              FramesSeen& seen, std::ostream& err) {
  ProgressLine progress(err);
  int code = kExitDone;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (inputs.size() > 1) progress.show(i, inputs.size());
    std::ostringstream problem;
    const int of_frame = runStep(kProgram, problem, [&] {
      addFrame(inputs[i], options, pool, seen);
      return kExitDone;
    });
    progress.clear();
    err << problem.str();
    code = std::max(code, of_frame);
  }
  return code;
}

/// Empty if no output is an input or its camera, else what is wrong.
std::string outputProblem(const std::string& out, const std::vector<SegmentInput>& inputs) {
  for (const char* ending : {".json", ".png"})
    for (const SegmentInput& input : inputs) {
      std::vector<std::string> files = {input.path, input.camera_file};
      if (input.source)
        for (const std::string& file : input.source->files(input.index)) files.push_back(file);
      for (const std::string& file : files)
        if (!file.empty() && filePlace(file) == filePlace(out + ending))
          return out + ending + " would overwrite an input or its camera";
    }
  std::error_code ignored;
  if (std::filesystem::is_regular_file(out + ".json", ignored)) {
    try {
      if (readJsonObject(out + ".json").contains("fx")) return out + ".json is a camera file: choose another name";
    } catch (const InputError&) {  // no JSON that anyone could miss
    }
  }
  return {};
}

std::string summary(const SensorMeasurement& measured, std::size_t frames) {
  const SensorEstimate& estimate = measured.estimate;
  char text[320];
  std::snprintf(text, sizeof text,
                "%zu %s, %zu blocks: %s\n"
                "  %.0f %% of the error's variance in blotches of %.1f px, an independent sample covers %.1f pixels\n",
                frames, frames == 1 ? "frame" : "frames", estimate.blocks, estimate.model().description().c_str(),
                100.0 * estimate.blotch_share, estimate.blotch_length,
                2.0 * 3.14159265358979 * estimate.effective_length * estimate.effective_length);
  return text;
}

}  // namespace

int noiseMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  NoiseCommandOptions options;
  if (const auto done = parseNoiseOptions(argc, argv, options, out, err)) return *done;
  return runProgram(kProgram, out, err, [&]() -> int {
    const InputList list = listInputs(options.input);
    std::string misuse = list.usage_problem;
    if (misuse.empty()) misuse = outputProblem(options.out, list.inputs);
    if (!misuse.empty()) return reportProblem(kProgram, err, misuse, kExitUsage);
    SensorPool pool;
    FramesSeen seen;
    const int code = addFrames(list.inputs, options.input, pool, seen, err);
    if (pool.frames() == 0) return std::max<int>(code, kExitInput);
    const SensorMeasurement measured = pool.measure();
    if (measured.estimate.blocks == 0)
      throw InputError(list.inputs.front().path, "frames", "have no smooth surface to measure the error on");
    writeTextFile(options.out + ".json", noiseJson(measured, pool.frames()));
    writeRgb(options.out + ".png", noisePicture(measured));
    out << summary(measured, pool.frames());
    const std::string doubts = doubtsAbout(seen, measured.estimate);
    if (!doubts.empty()) err << kProgram << ": " << doubts << '\n';
    return code;
  });
}

}  // namespace epcc
