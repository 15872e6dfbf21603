// SPDX-License-Identifier: BSD-3-Clause
// Waves of random direction, length and phase add up to a Gaussian field.
#include "datasets/noise/lasting_error.h"

#include <cmath>

#include "datasets/support/scene_random.h"

namespace epcc {
namespace {

constexpr std::uint64_t kLastingStream = 120;

/// Standard deviation of the noise's depth error at this depth and slant, metres.
double sigmaOf(const NoiseOptions& noise, double z, double slant) {
  if (noise.kind == NoiseKind::White) return noise.sensor.sigmaZ(z);
  if (noise.kind == NoiseKind::None) return 0.0;
  return slant * std::hypot(noise.stereo.sigma_w * z * z, noise.stereo.sigma_floor);
}

}  // namespace

LastingError::LastingError(double length, std::uint64_t seed) {
  SceneRandom random(seed, kLastingStream);
  for (Wave& wave : waves_) {
    for (int k = 0; k < 3; ++k) wave.vector(k) = random.normal() / length;
    wave.phase = random.uniform(0.0, 2.0 * M_PI);
  }
}

double LastingError::at(const Eigen::Vector3d& point) const {
  double sum = 0.0;
  for (const Wave& wave : waves_) sum += std::cos(wave.vector.dot(point) + wave.phase);
  return sum * std::sqrt(2.0 / static_cast<double>(waves_.size()));
}

void addLastingError(LabelledFrame& frame, const Eigen::Isometry3d& camera_to_world, const NoiseOptions& noise,
                     const LastingErrorOptions& options, const LastingError& field) {
  if (options.share <= 0.0 || noise.kind == NoiseKind::None) return;
  const PinholeCamera& camera = frame.camera.camera;
  Image<float> inverse(frame.depth.width, frame.depth.height);
  for (std::size_t i = 0; i < inverse.data.size(); ++i)
    if (frame.depth.data[i] > 0.0F) inverse.data[i] = 1.0F / frame.depth.data[i];
  const Image<float> slants = slantFactors(inverse, camera);
  const double weight = std::sqrt(options.share);
  for (int row = 0; row < frame.depth.height; ++row)
    for (int column = 0; column < frame.depth.width; ++column) {
      float& z = frame.depth.at(row, column);
      if (!(z > 0.0F)) continue;
      const Eigen::Vector3d ray((column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy, 1.0);
      const double sigma = sigmaOf(noise, z, slants.at(row, column));
      const double moved = z + weight * sigma * field.at(camera_to_world * (static_cast<double>(z) * ray));
      z = moved > 0.0 ? static_cast<float>(moved) : 0.0F;
    }
}

NoiseOptions freshNoise(NoiseOptions noise, const LastingErrorOptions& options) {
  noise.scale *= std::sqrt(1.0 - options.share);
  return noise;
}

}  // namespace epcc
