// SPDX-License-Identifier: BSD-3-Clause
// The frames that docs/research/accuracy.md is made of.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "datasets/sources/frame_source.h"

namespace epcc {

/// Data sets of the page. They are folders of AccuracyOptions::data, but for "sensors" and "lidars", which are the
/// depth images and the scans of the folder "sensors"; "synpeb" holds scans, too.
std::vector<std::string> accuracyDatasets();
/// False for "sensors" and "lidars", whose frames say nothing of their error: there is only the sensor measured.
bool namesItsNoise(const std::string& dataset);
/// What took a frame, in words: for "sensors" and "lidars" by the first word of the frame's name.
std::string sensorOf(const std::string& dataset, const std::string& frame);

/// Noise laid on the rendered scenes, as parseNoise() takes it.
std::vector<std::string> accuracyNoises();
/// A step in depth seen by a sensor; see datasets/rendered/step_frames.h.
struct AccuracyStep {
  std::string scene;   ///< door, frame
  std::string sensor;  ///< preset
  double metres;
};
std::vector<AccuracyStep> accuracySteps();
/// Name of the data set of a step, for example "door-realsense-100": millimetres.
std::string stepDataset(const AccuracyStep& step);
/// Name of the data set of a scene with a noise, for example "a-stereo".
std::string sceneDataset(const std::string& scene, const std::string& noise);

using FrameSources = std::vector<std::unique_ptr<FrameSource>>;

/// All frames of the page. Those with a name for their noise and those without are kept apart: the former have one
/// method more.
struct AccuracySources {
  FrameSources folders;  ///< opened, not scored themselves
  FrameSources named, unnamed;
  FrameSources named_copies, unnamed_copies;  ///< of cameras' frames
  FrameSources scenes;
  FrameSources steps;
  FrameSources sequence;  ///< one source or, if it is missing, none
};

/// Opens what is in the folder; every data set that is not there is a line in `problems`.
AccuracySources openAccuracySources(const std::string& folder, int scene_seeds, int step_seeds,
                                    std::vector<std::string>& problems);

}  // namespace epcc
