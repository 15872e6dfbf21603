// SPDX-License-Identifier: BSD-3-Clause
// Opens the sources, runs the methods over them, sorts the records.
#include "eval/accuracy/accuracy.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "baselines/epcc_segmenter.h"
#include "datasets/rendered/rendered_scenes.h"
#include "datasets/rendered/scene.h"
#include "datasets/rendered/step_frames.h"
#include "datasets/sources/dataset_registry.h"
#include "datasets/sources/frame_copies.h"
#include "datasets/support/input_error.h"
#include "eval/experiment/evaluation_files.h"
#include "eval/experiment/problem_list.h"
#include "eval/report/evaluation_report.h"

namespace epcc {

namespace {

using Sources = std::vector<std::unique_ptr<FrameSource>>;

const char kScans[] = "synpeb";

Method accuracyMethod(const std::string& name) {
  if (name != kAutoMethod) return registeredMethod(name);
  const Parameters parameters = defaultParameters().epcc;
  return {name, [parameters] { return std::make_unique<EpccSegmenter>(parameters, SensorChoice::Measured); }, true};
}

std::vector<Method> methodsOf(const std::vector<std::string>& names) {
  std::vector<Method> methods;
  for (const std::string& name : names) methods.push_back(accuracyMethod(name));
  return methods;
}

/// The methods that have their pictures taken, and the others.
std::vector<std::string> epccMethods() {
  return {"epcc", kAutoMethod, "epcc-paper"};
}
std::vector<std::string> otherMethods() {
  return {"region-growing", "ransac", "omps"};
}

Sources openDatasets(const std::string& folder, std::vector<std::string>& problems) {
  Sources sources;
  for (const std::string& name : accuracyDatasets()) {
    const std::string path = (std::filesystem::path(folder) / name).string();
    try {
      sources.push_back(openDataset(path));
    } catch (const InputError& error) {
      problems.emplace_back(error.what());
    }
  }
  return sources;
}

Sources copiesOf(const Sources& originals) {
  Sources copies;
  for (const auto& original : originals)
    for (const FrameCopy copy : frameCopies())
      if (original->dataset() != kScans) copies.push_back(std::make_unique<CopiedFrames>(*original, copy));
  return copies;
}

Sources sceneSources(int seeds) {
  Sources sources;
  for (const std::string& noise : accuracyNoises())
    for (const std::string& scene : sceneNames())
      sources.push_back(std::make_unique<RenderedFrames>(sceneDataset(scene, noise), 0, seeds,
                                                         sceneWithNoise(scene, parseNoise(noise).value())));
  return sources;
}

Sources stepSources(int seeds) {
  Sources sources;
  for (const AccuracyStep& step : accuracySteps()) {
    const StepSensor sensor = step.sensor == "realsense" ? realsenseSensor() : kinectSensor();
    const StepScene scene = step.scene == "door" ? doorScene(step.metres) : pictureFrameScene(step.metres);
    sources.push_back(std::make_unique<RenderedFrames>(stepDataset(step), 0, seeds, stepWithNoise(scene, sensor)));
  }
  return sources;
}

/// One experiment after the other, with one progress over all of them.
class AccuracyRun {
 public:
  AccuracyRun(const AccuracyOptions& options, const AccuracyProgress& progress)
      : options_(options), progress_(progress) {
    result_.rows = emptyFramesTable();
    originals_ = openDatasets(options.data, result_.problems);
    copies_ = copiesOf(originals_);
    scenes_ = sceneSources(options.seeds);
    steps_ = stepSources(options.step_seeds);
    const std::size_t pictured = listJobs(originals_).size() + listJobs(scenes_).size();
    total_ = 2 * pictured + listJobs(copies_).size() + listJobs(steps_).size();
  }

  AccuracyResult run() {
    const auto picture = [this](const FrameResult& frame) { writeOverlays(options_.out, frame); };
    const auto original = [this](const FrameRecord& record) { takeOriginal(record); };
    experiment(originals_, epccMethods(), picture, original);
    experiment(originals_, otherMethods(), {}, original);
    experiment(copies_, {"epcc", kAutoMethod}, {}, {});
    experiment(scenes_, epccMethods(), picture, {});
    experiment(scenes_, otherMethods(), {}, {});
    experiment(steps_, {"epcc", kAutoMethod}, {},
               [this](const FrameRecord& record) { result_.steps.push_back(record); });
    return std::move(result_);
  }

 private:
  using Take = std::function<void(const FrameRecord&)>;

  void experiment(const Sources& sources, const std::vector<std::string>& methods, const FrameDone& done,
                  const Take& take) {
    const auto in_order = [&](const std::vector<FrameRecord>& records) {
      for (const FrameRecord& record : records) {
        result_.all.add(record);
        addFrameRow(record, result_.rows);
        if (take) take(record);
      }
      for (const std::string& problem : frameProblems(records)) result_.problems.push_back(problem);
      if (progress_) progress_(++done_, total_);
    };
    runExperiment(listJobs(sources), methodsOf(methods), {{}, options_.jobs}, done, in_order);
  }

  void takeOriginal(const FrameRecord& record) {
    std::size_t& position = position_[{record.dataset, record.method}];
    result_.halves[position++ % 2].add(record);
    if (record.method == "epcc" || record.method == kAutoMethod) result_.frames.push_back(record);
  }

  const AccuracyOptions& options_;
  const AccuracyProgress& progress_;
  Sources originals_, copies_, scenes_, steps_;
  AccuracyResult result_;
  std::map<std::pair<std::string, std::string>, std::size_t> position_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
};

}  // namespace

std::vector<std::string> accuracyDatasets() {
  return {"realsense", "kinect", "abw", "icl", "structure", kScans};
}

std::vector<std::string> accuracyNoises() {
  return {"white:d435i", "stereo"};
}

std::vector<AccuracyStep> accuracySteps() {
  std::vector<AccuracyStep> steps;
  for (const char* sensor : {"kinect-v1", "realsense"})
    for (const double metres : {0.05, 0.10, 0.15, 0.20}) steps.push_back({"door", sensor, metres});
  for (const char* sensor : {"kinect-v1", "realsense"})
    for (const double metres : {0.01, 0.02, 0.03}) steps.push_back({"frame", sensor, metres});
  return steps;
}

std::string stepDataset(const AccuracyStep& step) {
  return step.scene + "-" + step.sensor + "-" + std::to_string(std::lround(1e3 * step.metres));
}

std::string sceneDataset(const std::string& scene, const std::string& noise) {
  return scene + "-" + noise.substr(0, noise.find(':'));
}

std::vector<std::string> accuracyMethods() {
  std::vector<std::string> methods = epccMethods();
  for (const std::string& name : otherMethods()) methods.push_back(name);
  return methods;
}

AccuracyResult runAccuracy(const AccuracyOptions& options, const AccuracyProgress& progress) {
  return AccuracyRun(options, progress).run();
}

}  // namespace epcc
