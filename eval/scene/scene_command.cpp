// SPDX-License-Identifier: BSD-3-Clause
// Renders one frame after the other into a folder, or prints the noise figures of a folder.
#include "eval/scene/scene_command.h"

#include <ostream>

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

}  // namespace

int sceneMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  SceneCommandOptions options;
  if (const auto done = parseSceneOptions(argc, argv, options, out, err)) return *done;
  return runProgram("epcc_scene", out, err, [&] {
    if (options.measure.empty())
      renderFrames(options, out, err);
    else
      out << noiseReport(options.measure);
    return kExitDone;
  });
}

}  // namespace epcc
