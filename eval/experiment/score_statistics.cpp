// SPDX-License-Identifier: BSD-3-Clause
// The scores are numbers of one frame each; means and deviations are taken score by score.
#include "eval/experiment/score_statistics.h"

#include <cmath>

namespace epcc {

Scores scoresOf(const FrameMeasures& measures) {
  const PaperMeasures& paper = measures.paper;
  const InstanceMeasures& instances = measures.instances;
  const auto share = [](long part, long whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
  };
  Scores scores{};
  scores[kClusters] = static_cast<double>(paper.clusters);
  scores[kDetected] = static_cast<double>(paper.detected);
  scores[kDetectedShare] = share(paper.detected, paper.surfaces);
  scores[kOverShare] = share(paper.over_segmented, paper.surfaces);
  scores[kUnderShare] = share(paper.under_segmented, paper.surfaces);
  scores[kCoverage] = share(instances.dominated_pixels, instances.plane_pixels);
  return scores;
}

Scores meanScores(const std::vector<Scores>& scores) {
  Scores mean{};
  for (const Scores& one : scores)
    for (std::size_t i = 0; i < kScoreCount; ++i) mean[i] += one[i] / static_cast<double>(scores.size());
  return mean;
}

Scores deviationScores(const std::vector<Scores>& scores) {
  Scores deviation{};
  if (scores.size() < 2) return deviation;
  const Scores mean = meanScores(scores);
  for (std::size_t i = 0; i < kScoreCount; ++i) {
    double sum = 0.0;
    for (const Scores& one : scores) sum += (one[i] - mean[i]) * (one[i] - mean[i]);
    deviation[i] = std::sqrt(sum / static_cast<double>(scores.size() - 1));
  }
  return deviation;
}

}  // namespace epcc
