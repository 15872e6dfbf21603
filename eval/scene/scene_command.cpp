// SPDX-License-Identifier: BSD-3-Clause
// Renders one frame after the other into a folder, single ones or a sequence, or prints the noise figures of a folder.
#include "eval/scene/scene_command.h"

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "datasets/files/trajectory_file.h"
#include "datasets/rendered/camera_path.h"
#include "datasets/rendered/scene_sequence.h"
#include "datasets/support/output_folder.h"
#include "eval/program/command_line.h"
#include "eval/program/progress_line.h"
#include "eval/scene/noise_report.h"
#include "eval/scene/scene_options.h"

namespace epcc {
namespace {

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

/// One scene and seed along the path; groundtruth.txt comes last.
void renderSequence(const SceneCommandOptions& options, std::ostream& out, std::ostream& err) {
  SequenceRecipe recipe;
  recipe.scene = options.scenes.front();
  recipe.seed = options.first_seed;
  if (isBuiltIn(options.path))
    recipe.path = options.path;
  else
    recipe.recorded = readTrajectory(options.path);
  recipe.frames = options.frames;
  recipe.rate = options.rate;
  recipe.options = options.scene;
  recipe.noise = options.noise;
  recipe.lasting = options.lasting;
  const SceneSequence sequence(recipe);
  makeOutputFolder(options.out);
  ProgressLine progress(err);
  const std::size_t frames = sequence.trajectory().size();
  for (std::size_t i = 0; i < frames; ++i) {
    writeLabelledFrame(options.out, sequence.frame(i));
    progress.show(i + 1, frames);
  }
  writeTrajectory((std::filesystem::path(options.out) / "groundtruth.txt").string(), sequence.trajectory());
  progress.clear();
  out << frames << (frames == 1 ? " frame" : " frames") << " and groundtruth.txt in " << options.out << '\n';
}

}  // namespace

int sceneMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  SceneCommandOptions options;
  if (const auto done = parseSceneOptions(argc, argv, options, out, err)) return *done;
  return runProgram("epcc_scene", out, err, [&] {
    if (!options.measure.empty())
      out << noiseReport(options.measure);
    else if (!options.path.empty())
      renderSequence(options, out, err);
    else
      renderFrames(options, out, err);
    return kExitDone;
  });
}

}  // namespace epcc
