// SPDX-License-Identifier: BSD-3-Clause
// A scene along a path of the camera, frame by frame.
#pragma once

#include <cstdint>
#include <string>

#include "datasets/files/trajectory_file.h"
#include "datasets/noise/lasting_error.h"
#include "datasets/rendered/scene.h"
#include "datasets/rendered/scene_geometry.h"

namespace epcc {

/// What a sequence is rendered of.
struct SequenceRecipe {
  std::string scene;  ///< "a", "b", "c", "d"
  std::uint64_t seed = 0;
  std::string path;  ///< a built-in one; empty: `recorded`
  Trajectory recorded;
  std::size_t frames = 0;  ///< 0: 300 of a built-in path, to the end of a recorded one
  double rate = 30.0;      ///< Hz
  SceneOptions options;
  NoiseOptions noise;
  LastingErrorOptions lasting;
};

/// Renders them. A surface keeps its number through the sequence; those of the arrangement's own view have the numbers
/// that they have in renderScene(), sides of boxes that come into view later those behind. Unlike there, surfaces may
/// be out of sight or fall apart.
class SceneSequence {
 public:
  /// std::invalid_argument for an unknown scene or path, or a camera that cannot be used.
  explicit SceneSequence(const SequenceRecipe& recipe);

  const Trajectory& trajectory() const { return trajectory_; }
  /// SCENE_SEED_PATH_NUMBER
  std::string name(std::size_t i) const;
  /// Frame `i`, with "pose" and "timestamp" in its JSON. The noise is drawn anew for each.
  LabelledFrame frame(std::size_t i) const;

 private:
  SequenceRecipe recipe_;
  Scene scene_;
  Trajectory trajectory_;
  LastingError field_;
};

}  // namespace epcc
