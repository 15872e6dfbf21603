// SPDX-License-Identifier: BSD-3-Clause
// Renders one frame after the other into a folder, single ones or a sequence, or prints the noise figures of a folder.
#include "eval/scene/scene_command.h"

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <set>

#include "datasets/files/labelled_frame.h"
#include "datasets/files/trajectory_file.h"
#include "datasets/rendered/camera_path.h"
#include "datasets/rendered/scene_sequence.h"
#include "datasets/support/file_place.h"
#include "datasets/support/input_error.h"
#include "datasets/support/output_folder.h"
#include "eval/program/command_line.h"
#include "eval/program/progress_line.h"
#include "eval/scene/noise_report.h"
#include "eval/scene/scene_options.h"

namespace epcc {
namespace {

constexpr const char* kProgram = "epcc_scene";

void renderFrames(const SceneCommandOptions& options, std::ostream& out, std::ostream& err) {
  makeOutputFolder(options.out);
  ProgressLine progress(err);
  const std::uint64_t seeds = options.last_seed - options.first_seed + 1;
  const std::size_t total = options.scenes.size() * static_cast<std::size_t>(seeds);
  std::size_t frames = 0;
  for (const std::string& scene : options.scenes) {
    for (std::uint64_t seed = options.first_seed;; ++seed) {
      LabelledFrame frame = renderScene(scene, seed, options.scene);
      applyNoise(frame, options.noise, seed);
      writeLabelledFrame(options.out, frame);
      progress.show(++frames, total);
      if (seed == options.last_seed) break;
    }
  }
  progress.clear();
  out << frames << (frames == 1 ? " frame" : " frames") << " in " << options.out << '\n';
}

bool isBuiltIn(const std::string& path) {
  const std::vector<std::string> names = pathNames();
  return std::find(names.begin(), names.end(), path) != names.end();
}

Trajectory recordedPath(const SceneCommandOptions& options) {
  const Trajectory recorded = readTrajectory(options.path);
  const double frames = (recorded.back().time - recorded.front().time) * options.rate;
  if (options.frames == 0 && frames > 1e6)
    throw InputError(options.path, "times", "span more than 1000000 frames at this --rate; --frames takes fewer");
  return recorded;
}

constexpr const char* kTruth = "groundtruth.txt";

/// Why the sequence cannot go into the folder, empty if it can: its frames would be mixed with others, or the
/// trajectory that is read be overwritten.
std::string folderProblem(const SceneCommandOptions& options, const SceneSequence& sequence) {
  const std::string truth = (std::filesystem::path(options.out) / kTruth).string();
  if (!isBuiltIn(options.path) && filePlace(truth) == filePlace(options.path))
    return "--out: " + truth + " would overwrite the file of --path";
  std::error_code ignored;
  if (!std::filesystem::is_directory(options.out, ignored)) return {};
  std::set<std::string> own;
  for (std::size_t i = 0; i < sequence.trajectory().size(); ++i) own.insert(sequence.name(i));
  for (const std::string& name : listLabelledFrames(options.out))
    if (own.count(name) == 0)
      return "--out: " + options.out + " has the frame " + name +
             ", which is not of this sequence: choose another folder";
  return {};
}

/// One scene and seed along the path; groundtruth.txt comes last.
int renderSequence(const SceneCommandOptions& options, std::ostream& out, std::ostream& err) {
  SequenceRecipe recipe;
  recipe.scene = options.scenes.front();
  recipe.seed = options.first_seed;
  if (isBuiltIn(options.path))
    recipe.path = options.path;
  else
    recipe.recorded = recordedPath(options);
  recipe.frames = options.frames;
  recipe.rate = options.rate;
  recipe.options = options.scene;
  recipe.noise = options.noise;
  recipe.lasting = options.lasting;
  const SceneSequence sequence(recipe);
  const std::string problem = folderProblem(options, sequence);
  if (!problem.empty()) return reportProblem(kProgram, err, problem, kExitUsage);
  makeOutputFolder(options.out, {kTruth});
  ProgressLine progress(err);
  const std::size_t frames = sequence.trajectory().size();
  for (std::size_t i = 0; i < frames; ++i) {
    writeLabelledFrame(options.out, sequence.frame(i));
    progress.show(i + 1, frames);
  }
  writeTrajectory((std::filesystem::path(options.out) / kTruth).string(), sequence.trajectory());
  progress.clear();
  out << frames << (frames == 1 ? " frame" : " frames") << " and groundtruth.txt in " << options.out << '\n';
  return kExitDone;
}

}  // namespace

int sceneMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  SceneCommandOptions options;
  if (const auto done = parseSceneOptions(argc, argv, options, out, err)) return *done;
  return runProgram(kProgram, out, err, [&]() -> int {
    if (!options.path.empty() && options.measure.empty()) return renderSequence(options, out, err);
    if (!options.measure.empty())
      out << noiseReport(options.measure);
    else
      renderFrames(options, out, err);
    return kExitDone;
  });
}

}  // namespace epcc
