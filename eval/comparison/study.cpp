// SPDX-License-Identifier: BSD-3-Clause
// Every variant is a method of an experiment; rows are its statistics.
#include "eval/comparison/study.h"

#include <stdexcept>

#include "baselines/epcc_segmenter.h"
#include "eval/comparison/line_statistics.h"
#include "eval/experiment/experiment.h"

namespace epcc {
namespace {

/// Scores by variant and seed.
using VariantScores = std::vector<std::vector<Scores>>;

std::vector<Method> methodsOf(const Study& study, const std::string& frames) {
  std::vector<Method> methods;
  for (const StudyVariant& variant : study.variants) {
    const Parameters parameters = variant.parameters(frames);
    methods.push_back({variant.row + " " + variant.column,
                       [parameters] { return std::make_unique<EpccSegmenter>(parameters); }, true});
  }
  return methods;
}

void addRecords(const std::vector<FrameRecord>& records, VariantScores& scores) {
  for (std::size_t v = 0; v < records.size(); ++v) {
    const FrameRecord& record = records[v];
    if (!record.error.empty()) throw std::runtime_error(record.method + " on " + record.frame + ": " + record.error);
    scores[v].push_back(scoresOf(record.measures));
  }
}

StudyRow makeRow(const std::string& frames, std::size_t variant, const std::vector<Scores>& scores) {
  StudyRow row;
  row.frames = frames;
  row.variant = variant;
  row.mean = meanScores(scores);
  row.deviation = deviationScores(scores);
  return row;
}

void addLineStatistics(const Study& study, const FrameSource& source, StudyRow& row) {
  const Parameters parameters = study.variants[row.variant].parameters(row.frames);
  for (std::size_t i = 0; i < source.size(); ++i) {
    const LineStatistics lines = lineStatistics(source.read(i), parameters, study.sensor);
    row.lines += lines.segments_per_line / static_cast<double>(source.size());
    row.line_share += lines.pixel_share / static_cast<double>(source.size());
  }
}

/// Seed by seed the mean over the sets of frames.
std::vector<Scores> meanOverFrames(const std::vector<VariantScores>& all, std::size_t variant) {
  std::vector<Scores> means;
  for (std::size_t seed = 0; seed < all.front()[variant].size(); ++seed) {
    std::vector<Scores> of_seed;
    for (const VariantScores& scores : all) of_seed.push_back(scores[variant][seed]);
    means.push_back(meanScores(of_seed));
  }
  return means;
}

}  // namespace

StudyResult runStudy(const Study& study, int jobs, const ComparisonProgress& progress) {
  StudyResult result;
  std::vector<VariantScores> all;
  std::size_t done = 0;
  const std::size_t total = study.frames.size() * static_cast<std::size_t>(study.seeds);
  for (const StudyFrames& frames : study.frames) {
    std::vector<std::unique_ptr<FrameSource>> sources;
    sources.push_back(std::make_unique<RenderedFrames>(frames.name, study.first_seed,
                                                       static_cast<std::size_t>(study.seeds), frames.make));
    const std::string first = sources[0]->name(0);
    StudyPicture& picture = result.pictures.emplace_back();
    picture.frames = frames.name;
    VariantScores& scores = all.emplace_back(study.variants.size());
    const auto keep = [&](const FrameResult& frame) {
      if (frame.file_name != first) return;  // true in one thread only
      picture.frame = frame.frame;
      picture.segmentations = frame.segmentations;
    };
    const auto add = [&](const std::vector<FrameRecord>& records) {
      addRecords(records, scores);
      if (progress) progress(++done, total);
    };
    runExperiment(listJobs(sources), methodsOf(study, frames.name), {study.sensor, jobs}, keep, add);
    if (!study.by_frames) continue;
    for (std::size_t v = 0; v < study.variants.size(); ++v) {
      result.rows.push_back(makeRow(frames.name, v, scores[v]));
      if (study.count_lines) addLineStatistics(study, *sources[0], result.rows.back());
    }
  }
  if (study.count_lines) return result;
  for (std::size_t v = 0; v < study.variants.size(); ++v)
    result.rows.push_back(makeRow("mean", v, meanOverFrames(all, v)));
  return result;
}

}  // namespace epcc
