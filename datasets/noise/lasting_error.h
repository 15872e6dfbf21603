// SPDX-License-Identifier: BSD-3-Clause
// The part of a depth error that stays with the scene: a smooth function of the place.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

#include "datasets/noise/sensor_noise.h"

namespace epcc {

/// Real depth cameras are wrong in the same way wherever they look at the same spot: matching errors hang on texture
/// and material. The simplest model of this: a share of the variance is a Gaussian field over the scene, of correlation
/// exp(-r^2 / (2 length^2)), that only the seed decides; the rest is drawn anew in each frame. The size of the error is
/// that of the noise at the depth and slant of the pixel, so that in a single frame nothing is larger than without.
/// What the model leaves out: that the error changes with the direction of view, and errors that stay with the pixel.
struct LastingErrorOptions {
  double share = 0.0;   ///< of the error's variance, 0 to 1
  double length = 0.1;  ///< metres
};

/// The field, of zero mean and unit variance: a sum of 64 plane waves.
class LastingError {
 public:
  LastingError(double length, std::uint64_t seed);
  double at(const Eigen::Vector3d& point) const;

 private:
  struct Wave {
    Eigen::Vector3d vector;
    double phase;
  };
  std::array<Wave, 64> waves_;
};

/// Moves every depth of an exact frame, seen from a pose, by the lasting part of the error: sqrt(share) times the
/// noise's standard deviation times the field at the place. The noise itself is then to be drawn with freshNoise().
void addLastingError(LabelledFrame& frame, const Eigen::Isometry3d& camera_to_world, const NoiseOptions& noise,
                     const LastingErrorOptions& options, const LastingError& field);

/// The noise with the rest of the variance.
NoiseOptions freshNoise(NoiseOptions noise, const LastingErrorOptions& options);

}  // namespace epcc
