// SPDX-License-Identifier: BSD-3-Clause
// Gives pixels new labels.
#pragma once

#include <cstddef>
#include <cstdint>

namespace epcc {

/// Labels that are looked at together.
constexpr std::size_t kRelabelledBlock = 16;

/// labels[i] = new_label[labels[i]].
void relabelPixels(std::int32_t* labels, std::size_t count, const std::int32_t* new_label);
/// to[i] = new_label[labels[i]]; they do not overlap.
void relabelPixels(const std::int32_t* labels, std::size_t count, const std::int32_t* new_label, std::int32_t* to);

}  // namespace epcc
