// SPDX-License-Identifier: BSD-3-Clause
// The command line of epcc_scene.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "datasets/noise/lasting_error.h"
#include "datasets/noise/sensor_noise.h"
#include "datasets/rendered/scene.h"

namespace epcc {

/// What epcc_scene is asked to do.
struct SceneCommandOptions {
  std::vector<std::string> scenes;  ///< names, at least one unless `measure` is set
  std::uint64_t first_seed = 0;
  std::uint64_t last_seed = 0;  ///< included
  NoiseOptions noise;
  SceneOptions scene;
  std::string path;        ///< of the camera, a built-in one or a file; empty: single frames
  std::size_t frames = 0;  ///< of the path; 0: all
  double rate = 30.0;      ///< Hz
  LastingErrorOptions lasting;
  std::string out;      ///< folder
  std::string measure;  ///< folder of real labelled frames to measure instead of rendering
};

/// Reads the command line. Returns an exit code if the program is done (help, version, or an error that has been
/// reported on `err` in one line), nothing if `options` is to be carried out.
std::optional<int> parseSceneOptions(int argc, const char* const* argv, SceneCommandOptions& options, std::ostream& out,
                                     std::ostream& err);

}  // namespace epcc
