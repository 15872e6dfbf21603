// SPDX-License-Identifier: BSD-3-Clause
// Sensor noise on rendered frames: none, white after a sensor model, or that of a stereo camera.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "datasets/files/labelled_frame.h"
#include "datasets/noise/stereo_noise.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

enum class NoiseKind {
  None,
  White,  ///< z + sigma_z(z) times a standard normal, every pixel on its own
  Stereo  ///< stereoDepth()
};

struct NoiseOptions {
  NoiseKind kind = NoiseKind::None;
  SensorModel sensor = *SensorModel::preset("d435i");  ///< White
  StereoNoise stereo;                                  ///< Stereo
  double scale = 1.0;  ///< of the error's size: below 1 where the rest of it is drawn elsewhere, see LastingError
  std::string preset = "rendered";  ///< sensor model that a segmenter should be told, written into the frame
};

/// The command line's form: `none | white:PRESET | white:A,B,L | white:poly:K1,K2,K3 | stereo | stereo-registered`.
/// On failure returns nothing and, if `why` is given, says what is wrong.
std::optional<NoiseOptions> parseNoise(const std::string& text, std::string* why = nullptr);

/// Replaces the depth; labels stay those of the exact scene. Same frame, options and seed: same bytes.
/// The frame's name takes part in the seed: scenes of one seed have different noise.
void applyNoise(LabelledFrame& frame, const NoiseOptions& options, std::uint64_t seed);

}  // namespace epcc
