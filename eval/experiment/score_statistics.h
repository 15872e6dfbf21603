// SPDX-License-Identifier: BSD-3-Clause
// The paper's measures of many frames as mean and standard deviation.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "eval/measures/frame_measures.h"

namespace epcc {

/// The numbers of one frame, in the order of kScoreNames.
enum Score : std::size_t { kClusters, kDetected, kDetectedShare, kOverShare, kUnderShare, kCoverage, kScoreCount };
using Scores = std::array<double, kScoreCount>;
/// Keys in files: IC and D are counts, the three shares are of N, coverage is the share of the surfaces' pixels that
/// lie in a cluster dominated by their surface.
constexpr std::array<const char*, kScoreCount> kScoreNames = {"IC",        "D",         "D_over_N",
                                                              "No_over_N", "Nu_over_N", "coverage"};

/// Scores of a frame; the shares of a frame without surfaces are 0.
Scores scoresOf(const FrameMeasures& measures);

/// Mean of several frames' scores; all zero for none.
Scores meanScores(const std::vector<Scores>& scores);
/// Sample standard deviation (n - 1); zero for fewer than two.
Scores deviationScores(const std::vector<Scores>& scores);

}  // namespace epcc
