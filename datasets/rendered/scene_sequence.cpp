// SPDX-License-Identifier: BSD-3-Clause
// One arrangement, many poses.
#include "datasets/rendered/scene_sequence.h"

#include <cstdio>
#include <stdexcept>

#include "datasets/files/frame_pose.h"
#include "datasets/rendered/camera_path.h"
#include "datasets/rendered/scene_frame.h"

namespace epcc {
namespace {

constexpr std::size_t kFrames = 300;

std::string numbered(const std::string& name, const std::string& path, std::size_t i) {
  char text[32];
  std::snprintf(text, sizeof text, "_%06zu", i);
  return name + '_' + (path.empty() ? "path" : path) + text;
}

}  // namespace

SceneSequence::SceneSequence(const SequenceRecipe& recipe)
    : recipe_(recipe), scene_(sceneArrangement(recipe.scene, recipe.seed)), field_(recipe.lasting.length, recipe.seed) {
  const std::string problem = recipe.options.camera.validate();
  if (!problem.empty()) throw std::invalid_argument(problem);
  trajectory_ = recipe.path.empty()
                    ? pathAlong(recipe.recorded, scene_, recipe.frames, recipe.rate)
                    : builtInPath(recipe.path, scene_, recipe.frames == 0 ? kFrames : recipe.frames, recipe.rate);
  scene_.showAllSides();
}

std::string SceneSequence::name(std::size_t i) const {
  return numbered(sceneFrameName(recipe_.scene, recipe_.seed), recipe_.path, i);
}

LabelledFrame SceneSequence::frame(std::size_t i) const {
  const StampedPose& stamped = trajectory_.at(i);
  LabelledFrame frame = sceneFrame(recipe_.scene, recipe_.seed, scene_,
                                   renderView(scene_, recipe_.options.camera, stamped.pose), recipe_.options);
  frame.name = name(i);
  frame.camera.name = frame.name;
  addLastingError(frame, stamped.pose, recipe_.noise, recipe_.lasting, field_);
  applyNoise(frame, freshNoise(recipe_.noise, recipe_.lasting), recipe_.seed);
  setFramePose(stamped.pose, frame);
  frame.camera.extra["timestamp"] = stamped.time;
  return frame;
}

}  // namespace epcc
