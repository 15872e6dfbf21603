// SPDX-License-Identifier: BSD-3-Clause
// Measures a sensor's error on labelled planes: its size by depth and its autocorrelation.
#pragma once

#include <array>
#include <vector>

#include "datasets/files/labelled_frame.h"

namespace epcc {

constexpr std::array<double, 9> kNoiseDepths = {0.2, 0.4, 0.6, 0.8, 1.0, 1.4, 1.8, 2.3, 3.2};  ///< bin borders, metres
constexpr std::array<int, 6> kNoiseLags = {1, 2, 4, 8, 16, 24};                                ///< pixels

struct NoiseFigures {
  /// Root mean square of the axial residual over sqrt(1 + tan^2 theta), metres; 0 for an empty bin.
  std::array<double, kNoiseDepths.size() - 1> rms{};
  std::array<long, kNoiseDepths.size() - 1> pixels{};
  /// Autocorrelation of the residual along rows and along columns at kNoiseLags, mean over the planes by pixel pairs.
  std::array<double, kNoiseLags.size()> along_rows{};
  std::array<double, kNoiseLags.size()> along_columns{};
  int planes = 0;
  double outlier_share = 0.0;  ///< of the planes' pixels with depth, outside 3 times the 68 % quantile
};

/// Fits every labelled plane in inverse depth (least squares, gated) and pools what is left. Planes with fewer than
/// 1000 pixels do not count.
NoiseFigures measureNoise(const std::vector<LabelledFrame>& frames);

/// The frame with every labelled plane replaced by its fit, exact; no depth elsewhere.
LabelledFrame flattened(const LabelledFrame& frame);

}  // namespace epcc
