// SPDX-License-Identifier: BSD-3-Clause
// Scenes whose planes are known, under errors whose size and correlation are known.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "datasets/files/labelled_frame.h"
#include "epcc_segmentation/sensor_model.h"
#include "epcc_segmentation/vectors.h"

namespace epcc {

/// A kind of error and the sensor model that is right for it.
struct RenderedError {
  std::string name;
  SensorModel sensor;
  bool is_stereo = false;  ///< stereoDepth(); else Gaussian with the sensor's size and correlation length
};

/// White error, blotches of 2 and of 4 pixels, rendered stereo.
std::vector<RenderedError> renderedErrors();

/// The exact frame of a scene and its planes by label, unit normals, metres.
struct KnownScene {
  explicit KnownScene(const std::string& name);
  LabelledFrame exact;
  std::map<int, Vector4> planes;

  /// The frame with an error, another for each run.
  LabelledFrame rendering(const RenderedError& error, int run) const;
};

}  // namespace epcc
