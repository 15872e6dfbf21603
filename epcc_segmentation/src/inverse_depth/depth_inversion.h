// SPDX-License-Identifier: BSD-3-Clause
// A row of depths -> inverse depths and their weights, in vectors.
#pragma once

#include <cstddef>

namespace epcc {

struct InverseDepthNoise;

/// w = 1/z of each depth; 0 where z is not positive and finite, or its inverse is not.
void invertDepths(const float* depth, std::size_t count, float* w);

/// 1/sigma_w^2 of each inverse depth; measured inverse depth = w * scale. Finite and positive for any w.
void weighInverseDepths(const float* w, std::size_t count, const InverseDepthNoise& noise, float scale, float* weight);

}  // namespace epcc
