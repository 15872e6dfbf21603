// SPDX-License-Identifier: BSD-3-Clause
// Runs the methods over the sources and sorts the records.
#include "eval/accuracy/accuracy.h"

#include <atomic>
#include <map>
#include <mutex>
#include <utility>

#include "epcc_segmentation/on_threads.h"
#include "eval/experiment/evaluation_files.h"
#include "eval/experiment/problem_list.h"
#include "eval/program/command_line.h"
#include "eval/report/evaluation_report.h"

namespace epcc {

namespace {

using Names = std::vector<std::string>;

/// Methods for frames that do not name their noise: "epcc" would be "epcc-auto" once more.
Names withoutGiven(Names methods) {
  Names left;
  for (std::string& method : methods)
    if (method != "epcc") left.push_back(std::move(method));
  return left;
}

/// One experiment after the other, with one progress over all of them.
class AccuracyRun {
 public:
  AccuracyRun(const AccuracyOptions& options, const AccuracyProgress& progress)
      : options_(options), progress_(progress) {
    result_.rows = emptyFramesTable();
    sources_ = openAccuracySources(options.data, options.seeds, options.step_seeds, result_.problems);
    for (const FrameSources* sources : {&sources_.named, &sources_.unnamed})
      total_ += 3 * listJobs(*sources).size();  // with pictures, without, and for the curve
    total_ += 2 * listJobs(sources_.scenes).size();
    for (const FrameSources* sources :
         {&sources_.named_copies, &sources_.unnamed_copies, &sources_.steps, &sources_.sequence})
      total_ += listJobs(*sources).size();
  }

  AccuracyResult run() {
    const auto picture = [this](const FrameResult& frame) { writeOverlays(options_.out, frame); };
    const auto original = [this](const FrameRecord& record) { takeOriginal(record); };
    const auto step = [this](const FrameRecord& record) { result_.steps.push_back(record); };
    const Names inverse_depth = {kAutoMethod, "epcc"};
    score(sources_.named, epccMethods(), picture, original);
    score(sources_.unnamed, withoutGiven(epccMethods()), picture, original);
    score(sources_.named, otherMethods(), {}, original, result_.failures);
    score(sources_.unnamed, otherMethods(), {}, original, result_.failures);
    score(sources_.named_copies, inverse_depth, {}, {});
    score(sources_.unnamed_copies, withoutGiven(inverse_depth), {}, {});
    score(sources_.scenes, epccMethods(), picture, {});
    score(sources_.scenes, otherMethods(), {}, {}, result_.failures);
    score(sources_.steps, inverse_depth, {}, step);
    drawCurve(sources_.named);
    drawCurve(sources_.unnamed);
    measureRepeatability();
    return std::move(result_);
  }

 private:
  using Take = std::function<void(const FrameRecord&)>;

  void score(const FrameSources& sources, const Names& methods, const FrameDone& done, const Take& take) {
    score(sources, methods, done, take, result_.problems);
  }

  void score(const FrameSources& sources, const Names& methods, const FrameDone& done, const Take& take,
             std::vector<std::string>& problems) {
    const auto take_row = [&](const FrameRecord& record) {
      result_.all.add(record);
      addFrameRow(record, result_.rows);
      if (take) take(record);
    };
    experiment(sources, methodsOf(methods), options_.jobs, done, take_row, problems);
  }

  void experiment(const FrameSources& sources, const std::vector<Method>& methods, int jobs, const FrameDone& done,
                  const Take& take, std::vector<std::string>& problems) {
    const auto in_order = [&](const std::vector<FrameRecord>& records) {
      for (const FrameRecord& record : records) take(record);
      for (const std::string& problem : frameProblems(records)) problems.push_back(problem);
      advance();
    };
    runExperiment(listJobs(sources), methods, {{}, jobs}, done, in_order);
  }

  void takeOriginal(const FrameRecord& record) {
    std::size_t& position = position_[{record.dataset, record.method}];
    result_.halves[position++ % 2].add(record);
    FrameRecord by_sensor = record;
    by_sensor.dataset = sensorOf(record.dataset, record.frame);
    result_.sensors.add(by_sensor);
    if (record.method == "epcc" || record.method == kAutoMethod) result_.frames.push_back(record);
  }

  void drawCurve(const FrameSources& sources) {
    const auto take = [this](const FrameRecord& record) { result_.curve.add(record); };
    experiment(sources, curveMethods(), threadsFor(0), {}, take, result_.problems);
  }

  /// Both halves at a time: what they repeat does not depend on it.
  void measureRepeatability() {
    std::atomic<std::size_t> next{0};
    onThreads(2, [&] {
      for (std::size_t half = next++; half < 2; half = next++) {
        FrameJobs jobs = listJobs(sources_.sequence);
        const std::size_t middle = jobs.size() / 2;
        jobs.keepIf([&](const FrameJob& job) { return (job.position >= middle) == (half == 1); });
        result_.repeatability[half] = measureSequences(jobs, sequenceMethods(), {{}, accuracyLags()},
                                                       [this](std::size_t, std::size_t) { advance(); });
      }
    });
    for (const SequenceResult& half : result_.repeatability)
      for (const std::string& problem : half.problems) result_.problems.push_back(problem);
  }

  void advance() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++done_;
    if (progress_) progress_(done_, total_);
  }

  const AccuracyOptions& options_;
  const AccuracyProgress& progress_;
  AccuracySources sources_;
  AccuracyResult result_;
  std::map<std::pair<std::string, std::string>, std::size_t> position_;
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
};

}  // namespace

std::vector<int> accuracyLags() {
  return {5, 25, 75};
}

AccuracyResult runAccuracy(const AccuracyOptions& options, const AccuracyProgress& progress) {
  return AccuracyRun(options, progress).run();
}

}  // namespace epcc
