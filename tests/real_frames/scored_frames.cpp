// SPDX-License-Identifier: BSD-3-Clause
// Reads and segments each frame, and counts overlaps with its truth.
#include "tests/real_frames/scored_frames.h"

#include <algorithm>

#include "datasets/support/input_error.h"
#include "epcc_segmentation/plane_extractor.h"

namespace epcc::test {

namespace {

void scoreLargestSurface(const OverlapTable& table, FrameScore& score) {
  std::size_t largest = 0;
  long scored = 0;
  for (std::size_t g = 0; g <= table.surfaceCount(); ++g) {
    scored += table.surfaceSize(g);
    if (g > 0 && (largest == 0 || table.surfaceSize(g) > table.surfaceSize(largest))) largest = g;
  }
  if (largest == 0) return;
  long covered = 0;
  for (std::size_t c = 1; c <= table.clusterCount(); ++c)
    if (table.dominant(c) == largest) covered += table.overlap(c, largest);
  const auto size = static_cast<double>(table.surfaceSize(largest));
  score.largest_surface = table.surfaceIds()[largest];
  score.largest_coverage = static_cast<double>(covered) / size;
  score.largest_share = size / static_cast<double>(scored);
}

}  // namespace

FrameScore scoreFrame(const LabelledFrame& frame, const Parameters& parameters) {
  FrameScore score;
  score.name = frame.name;
  if (frame.labels.empty()) score.problem = "has no labels";
  const auto sensor = SensorModel::parse(frame.camera.noise.value_or(""), &score.problem);
  if (!sensor || !score.problem.empty()) return score;
  PlaneExtractor extractor(parameters, *sensor);
  PlaneSegmentation result;
  if (!extractor.extract(frameView(frame), result)) {
    score.problem = extractor.error();
    return score;
  }
  const std::vector<std::int32_t> truth(frame.labels.data.begin(), frame.labels.data.end());
  std::vector<std::uint8_t> valid(truth.size());
  std::transform(frame.depth.data.begin(), frame.depth.data.end(), valid.begin(),
                 [](float depth) { return static_cast<std::uint8_t>(depth > 0.0f); });
  const OverlapTable table(result.labels, truth, valid);
  score.paper = paperMeasures(table);
  score.segcomp = segcompMeasures(table);
  scoreLargestSurface(table, score);
  return score;
}

std::vector<FrameScore> scoreFolder(const std::string& folder, const Parameters& parameters) {
  std::vector<FrameScore> scores;
  for (const std::string& name : listLabelledFrames(folder)) {
    try {
      scores.push_back(scoreFrame(readLabelledFrame(folder, name), parameters));
    } catch (const InputError& error) {
      scores.push_back({});
      scores.back().name = name;
      scores.back().problem = error.what();
    }
  }
  return scores;
}

}  // namespace epcc::test
