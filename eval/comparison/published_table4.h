// SPDX-License-Identifier: BSD-3-Clause
// The numbers of the paper's Table 4.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace epcc {

/// IC, D, D/N, N_o/N, N_u/N, in the order of kScoreNames.
using PublishedScores = std::array<double, 5>;

/// Table 4 for scene "a" to "d", or "mean" for the mean of the four, and the method "region-growing", "ransac" or
/// "epcc-paper"; nothing for what the paper does not have.
std::optional<PublishedScores> publishedTable4(const std::string& scene, const std::string& method);

}  // namespace epcc
