// SPDX-License-Identifier: BSD-3-Clause
// Walls with a step in depth little above the error: a door set back in its wall, a picture frame standing out of it.
#pragma once

#include <string>
#include <vector>

#include "datasets/rendered/rendered_scenes.h"

namespace epcc {

/// A wall `distance` metres away and a second plane `step` metres behind it (in front of it if negative), parallel.
struct StepScene {
  std::string name;
  double distance;
  double step;
  /// Outline of the second plane, metres; `top` and `bottom` downwards from the middle of the view.
  double width, top, bottom;
  /// Width of its border if there is nothing but a border, else 0.
  double rim;
};

/// 90 cm wide, 3 m away, reaches below the view.
StepScene doorScene(double step);
/// 60 cm by 50 cm, 1 m away, its border 8 cm wide.
StepScene pictureFrameScene(double step);

/// A sensor with its camera and error.
struct StepSensor {
  std::string name;
  PinholeCamera camera;
  NoiseOptions noise;
};

/// Kinect v1: the stereo noise with the size and correlation length of real Kinect frames, 0.0014 z^2 and 4 pixels.
StepSensor kinectSensor();
/// RealSense D4xx at its native resolution: the stereo noise as it is.
StepSensor realsenseSensor();

/// Label 1 the wall, 2 the second plane; what is seen of the wall through a frame is not scored. The seed turns the
/// wall by up to 20 degrees to either side, shifts the second plane by up to 20 cm, and draws the noise.
RenderedFrames::Make stepWithNoise(const StepScene& scene, const StepSensor& sensor);

}  // namespace epcc
