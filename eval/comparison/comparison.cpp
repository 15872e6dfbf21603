// SPDX-License-Identifier: BSD-3-Clause
// Scene by scene: frames rendered once, then every group of methods on them, on several threads.
#include "eval/comparison/comparison.h"

#include <algorithm>
#include <stdexcept>

#include "datasets/rendered/rendered_scenes.h"
#include "datasets/rendered/scene.h"
#include "datasets/support/quantile.h"
#include "eval/experiment/experiment.h"

namespace epcc {
namespace {

/// Methods that share a sensor model and a number of seeds.
struct MethodGroup {
  std::vector<std::string> methods;
  std::string sensor;  ///< as frameSensor() takes it; empty: that of the frame
  int seeds = 0;
};

std::vector<MethodGroup> methodGroups(const ComparisonOptions& options) {
  const bool paper = options.parameters == ParameterSet::Paper;
  return {{{"region-growing", "ransac"}, "", options.slow_seeds},
          {{"epcc-paper"}, paper ? "d435i" : "", options.seeds},
          {{"epcc"}, "", options.seeds}};
}

/// What one method did on one scene, by seed.
struct MethodRuns {
  std::vector<Scores> scores;
  std::vector<double> times_ms;
  double surfaces = 0.0;  ///< summed over the seeds
};
using SceneRuns = std::map<std::string, MethodRuns>;

void addRecord(const FrameRecord& record, SceneRuns& runs) {
  if (!record.error.empty()) throw std::runtime_error(record.method + " on " + record.frame + ": " + record.error);
  MethodRuns& method = runs[record.method];
  method.scores.push_back(scoresOf(record.measures));
  method.times_ms.push_back(record.ms.value_or(0.0));
  method.surfaces += static_cast<double>(record.measures.paper.surfaces);
}

SegmenterOptions parametersOf(const std::string& scene, ParameterSet set) {
  if (set == ParameterSet::Default) return defaultParameters();
  return paperParameters(scene.at(0)).value();
}

/// Runs a group on a scene's first seeds; keeps the segmentations of the first one for the picture.
void runGroup(const MethodGroup& group, const ComparisonOptions& options,
              const std::vector<std::unique_ptr<FrameSource>>& sources, ComparedFrame& picture, SceneRuns& runs,
              const std::function<void()>& frame_done) {
  std::vector<Method> methods;
  for (const std::string& name : group.methods)
    methods.push_back(registeredMethod(name, parametersOf(picture.scene, options.parameters)));
  FrameJobs jobs = listJobs(sources);
  jobs.keepFirst(static_cast<std::size_t>(group.seeds));
  const std::string first = sources[0]->name(0);
  const auto keep = [&](const FrameResult& result) {
    if (result.file_name != first || result.segmentations.empty()) return;  // true in one thread only
    picture.frame = result.frame;
    for (std::size_t m = 0; m < methods.size(); ++m) picture.segmentations[methods[m].name] = result.segmentations[m];
  };
  const auto add = [&](const std::vector<FrameRecord>& records) {
    for (const FrameRecord& record : records) addRecord(record, runs);
    frame_done();
  };
  runExperiment(jobs, methods, {group.sensor, options.jobs}, keep, add);
}

ComparisonRow makeRow(const std::string& scene, const std::string& method, const MethodRuns& runs) {
  ComparisonRow row;
  row.scene = scene;
  row.method = method;
  row.seeds = static_cast<int>(runs.scores.size());
  row.surfaces = runs.surfaces / static_cast<double>(runs.scores.size());
  row.mean = meanScores(runs.scores);
  row.deviation = deviationScores(runs.scores);
  row.median_ms = median(runs.times_ms);
  row.published = publishedTable4(scene, method);
  return row;
}

/// Seed by seed the mean over the scenes.
MethodRuns meanOverScenes(const std::vector<SceneRuns>& scenes, const std::string& method) {
  MethodRuns mean;
  const std::size_t seeds = scenes.front().at(method).scores.size();
  for (std::size_t seed = 0; seed < seeds; ++seed) {
    std::vector<Scores> of_seed;
    double ms = 0.0;
    for (const SceneRuns& scene : scenes) {
      of_seed.push_back(scene.at(method).scores[seed]);
      ms += scene.at(method).times_ms[seed];
    }
    mean.scores.push_back(meanScores(of_seed));
    mean.times_ms.push_back(ms / static_cast<double>(scenes.size()));
  }
  for (const SceneRuns& scene : scenes) mean.surfaces += scene.at(method).surfaces / static_cast<double>(scenes.size());
  return mean;
}

void check(const ComparisonOptions& options) {
  if (options.scenes.empty()) throw std::invalid_argument("name at least one scene");
  if (options.seeds < 1 || options.slow_seeds < 1) throw std::invalid_argument("at least one seed");
}

}  // namespace

std::vector<std::string> comparedMethods() {
  return {"region-growing", "ransac", "epcc-paper", "epcc"};
}

Comparison runComparison(const ComparisonOptions& options, const ComparisonProgress& progress) {
  check(options);
  const std::vector<MethodGroup> groups = methodGroups(options);
  std::size_t done = 0, total = 0;
  for (const MethodGroup& group : groups) total += static_cast<std::size_t>(group.seeds) * options.scenes.size();
  const auto frame_done = [&] {
    ++done;
    if (progress) progress(done, total);
  };

  Comparison comparison;
  std::vector<SceneRuns> runs;
  for (const std::string& scene : options.scenes) {
    std::vector<std::unique_ptr<FrameSource>> sources;
    sources.push_back(std::make_unique<RenderedFrames>(
        scene, options.first_seed, static_cast<std::size_t>(std::max(options.seeds, options.slow_seeds)),
        sceneWithNoise(scene, options.noise)));
    ComparedFrame& picture = comparison.frames.emplace_back();
    picture.scene = scene;
    SceneRuns& of_scene = runs.emplace_back();
    for (const MethodGroup& group : groups) runGroup(group, options, sources, picture, of_scene, frame_done);
    for (const std::string& method : comparedMethods())
      comparison.rows.push_back(makeRow(scene, method, of_scene.at(method)));
  }
  if (options.scenes.size() < sceneNames().size()) return comparison;
  for (const std::string& method : comparedMethods())
    comparison.rows.push_back(makeRow("mean", method, meanOverScenes(runs, method)));
  return comparison;
}

}  // namespace epcc
