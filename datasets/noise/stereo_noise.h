// SPDX-License-Identifier: BSD-3-Clause
// The error of an active stereo camera, made in disparity: blotches, quantised steps, soft edges, shadows, holes.
#pragma once

#include <cstdint>

#include "datasets/files/image.h"
#include "epcc_segmentation/depth_frame.h"

namespace epcc {

/// Calibrated on real RealSense D4xx frames (docs/reference/evaluation.md). Pixels are those of the sensor's own grid.
struct StereoNoise {
  /// Standard deviation of the inverse depth on a surface that faces the camera, 1/m.
  double sigma_w = 0.0045;
  /// Further error of the depth itself, metres; matters below half a metre.
  double sigma_floor = 0.0004;
  /// Pixels of the frame's grid per pixel of the sensor's: 1 native, 1.6 for depth warped to a 640-wide colour image.
  double grid_scale = 1.0;
  /// Correlation length l of the blotches, exp(-r^2 / 2 l^2), pixels.
  double blotch = 6.2;
  /// Share of the variance that is white, pixel by pixel.
  double white_share = 0.015;
  /// Share of the variance in small blotches, a third of `blotch`.
  double small_share = 0.08;
  /// Share of the variance in slow bending, three times `blotch`.
  double slow_share = 0.25;
  /// Distance between the two imagers, metres.
  double baseline = 0.05;
  /// Steps of the disparity, pixels.
  double disparity_step = 1.0 / 32.0;
  /// Wobble of the edges, standard deviation in pixels.
  double edge_wobble = 0.8;
  /// Share of the pixels at an edge that fly between foreground and background.
  double flying_share = 0.3;
  /// Share of wrong matches, in small blobs.
  double outlier_share = 0.015;
  /// Share of holes without occlusion shadows: half in specks, half in blobs.
  double hole_share = 0.02;
  /// Leave out what the occluded second imager cannot see.
  bool shadows = true;
};

/// Depth as the sensor would deliver it, in whole millimetres, 0 = invalid. `depth` is exact, metres, 0 = invalid.
DepthImage stereoDepth(const DepthImage& depth, const PinholeCamera& camera, const StereoNoise& noise,
                       std::uint64_t seed);

/// How much the error grows on a slanted surface: sqrt(1 + tan^2) of the angle between viewing ray and normal, tan^2
/// at most 25; 0 where there is no depth. From the differences of the inverse depth, exact on planes.
Image<float> slantFactors(const Image<float>& inverse_depth, const PinholeCamera& camera);

}  // namespace epcc
