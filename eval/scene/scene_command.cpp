// SPDX-License-Identifier: BSD-3-Clause
// Renders one frame after the other into a folder, or prints the noise figures of a folder.
#include "eval/scene/scene_command.h"

#include <unistd.h>

#include <filesystem>
#include <ostream>

#include "datasets/support/input_error.h"
#include "eval/program/command_line.h"
#include "eval/scene/noise_report.h"
#include "eval/scene/scene_options.h"

namespace epcc {
namespace {

void makeFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder))
    throw OutputError(folder, "folder", "cannot be made" + (error ? ", " + error.message() : std::string()));
}

void renderFrames(const SceneCommandOptions& options, std::ostream& out, std::ostream& err) {
  const bool progress = isatty(STDERR_FILENO) != 0;
  makeFolder(options.out);
  std::size_t frames = 0;
  for (const std::string& scene : options.scenes) {
    for (std::uint64_t seed = options.first_seed;; ++seed) {
      LabelledFrame frame = renderScene(scene, seed, options.scene);
      applyNoise(frame, options.noise, seed);
      writeLabelledFrame(options.out, frame);
      ++frames;
      if (progress) err << "\r\033[K" << frame.name << std::flush;
      if (seed == options.last_seed) break;
    }
  }
  if (progress) err << "\r\033[K" << std::flush;
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
