// SPDX-License-Identifier: BSD-3-Clause
// A row of depths -> inverse depths and their weights, in vectors.
#pragma once

#include <cstddef>

namespace epcc {

struct InverseDepthNoise;

/// What a sensor may measure, metres: no depth and no coordinate is beyond 100 km, and no depth below a micrometre.
/// Within it all sums of squares are numbers, on every vector unit the same.
constexpr float kFarthestMeasured = 1e5f;
constexpr float kLargestInverse = 1e6f;

/// w = 1/z of each depth; 0 where z is not positive, or beyond what may be measured.
void invertDepths(const float* depth, std::size_t count, float* w);

/// 1/sigma_w^2 of each inverse depth; measured inverse depth = w * scale. Finite and positive for any w.
void weighInverseDepths(const float* w, std::size_t count, const InverseDepthNoise& noise, float scale, float* weight);

}  // namespace epcc
