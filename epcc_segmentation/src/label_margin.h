// SPDX-License-Identifier: BSD-3-Clause
// Which labels of a row have none but their own near them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace epcc {

/// Rows of labels are read, and the result is written, so far beyond `count`.
constexpr std::size_t kBehindLabels = 16;

/// inside[i] is labels[i], or 0 if at i - margin or i + margin in the row, or at i in the row above or below, there is
/// another label, or none. `margin` labels before and after the row are read too.
void keepInside(const std::int32_t* labels, const std::int32_t* above, const std::int32_t* below, std::size_t count,
                std::size_t margin, std::int32_t* inside);

}  // namespace epcc
