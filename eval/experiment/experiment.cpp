// SPDX-License-Identifier: BSD-3-Clause
// Threads take frame after frame through every method; records are handed on in the order of the frames.
#include "eval/experiment/experiment.h"

#include <algorithm>
#include <atomic>
#include <new>
#include <stdexcept>

#include "baselines/imported_labels_segmenter.h"
#include "datasets/support/input_error.h"
#include "epcc_segmentation/on_threads.h"
#include "eval/experiment/in_order.h"
#include "eval/experiment/timed_experiment.h"
#include "eval/program/frame_sensor.h"
#include "eval/program/memory_reserve.h"

namespace epcc {

namespace {

constexpr const char* kTooLittleMemory = "needs more memory than there is";

LabelledFrame readScorable(const FrameJob& job) {
  LabelledFrame frame = job.source->read(job.index);
  if (frame.labels.empty()) throw InputError(job.file_name, "labels", "there are none, the frame cannot be scored");
  return frame;
}

void runMethod(const Method& method, PlaneSegmenter& segmenter, const FrameSensor& sensor, const FrameJob& job,
               const LabelledFrame& frame, PlaneSegmentation& segmentation, FrameRecord& record) {
  const SegmenterInput input = {frameView(frame), sensor.model, job.file_name, sensor.is_measured};
  if (!segmenter.segment(input, segmentation)) {
    record.error = printable(segmenter.error(), 1000);
    return;
  }
  record.doubt = doubtsAbout(frame, sensor, segmentation).inWords();
  record.measures = measureFrame(frame, segmentation);
  if (method.timed) record.ms = 1e3 * segmenter.seconds();
}

FrameResult emptyResult(const FrameJob& job, const std::vector<Method>& methods) {
  FrameResult result;
  result.index = job.index;
  result.file_name = job.file_name;
  for (const Method& method : methods)
    result.records.push_back({job.source->dataset(), job.source->name(job.index), method.name, {}, {}, {}});
  return result;
}

}  // namespace

Method registeredMethod(const std::string& name, const SegmenterOptions& options) {
  if (!makeSegmenter(name, options)) throw std::invalid_argument("there is no method " + name);
  return {name, [name, options] { return makeSegmenter(name, options); }, true};
}

Method importedMethod(const std::string& name, const std::string& folder) {
  return {name, [name, folder] { return std::make_unique<ImportedLabelsSegmenter>(name, folder); }, false};
}

Segmenters makeSegmenters(const std::vector<Method>& methods) {
  Segmenters segmenters;
  for (const Method& method : methods) segmenters.push_back(method.make());
  return segmenters;
}

FrameResult failedFrame(const FrameJob& job, const std::vector<Method>& methods, const std::string& error) {
  FrameResult result = emptyResult(job, methods);
  result.reading_error = printable(error, 1000);
  for (FrameRecord& record : result.records) record.error = result.reading_error;
  return result;
}

FrameResult evaluateFrame(const FrameJob& job, const std::vector<Method>& methods, const Segmenters& segmenters,
                          const ExperimentOptions& options) {
  reserveMemory();  // a frame before may have needed it
  try {
    FrameResult result = emptyResult(job, methods);
    result.frame = readScorable(job);
    readAs(result.frame, options.reading);
    result.segmentations.resize(methods.size());
    const FrameSensor sensor =
        frameSensor(options.noise, result.frame.camera.noise, frameView(result.frame), result.frame.name + ".json");
    for (std::size_t m = 0; m < methods.size(); ++m)
      runMethod(methods[m], *segmenters[m], sensor, job, result.frame, result.segmentations[m], result.records[m]);
    return result;
  } catch (const std::bad_alloc&) {
    return failedFrame(job, methods, kTooLittleMemory);
  } catch (const std::exception& error) {
    return failedFrame(job, methods, error.what());
  }
}

FrameResult finishFrame(const FrameJob& job, const std::vector<Method>& methods, const Segmenters& segmenters,
                        const ExperimentOptions& options, const FrameDone& done) {
  FrameResult result = evaluateFrame(job, methods, segmenters, options);
  if (!done) return result;
  try {
    done(result);
  } catch (const std::bad_alloc&) {
    result = failedFrame(job, methods, kTooLittleMemory);
    done(result);
  }
  return result;
}

void runExperiment(const FrameJobs& jobs, const std::vector<Method>& methods, const ExperimentOptions& options,
                   const FrameDone& done, const FrameInOrder& in_order) {
  if (options.frame_timeout > 0.0) return runTimedExperiment(jobs, methods, options, done, in_order);
  InOrder sorter(in_order);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    try {
      const auto segmenters = makeSegmenters(methods);
      for (std::size_t i = next++; i < jobs.size(); i = next++) {
        FrameResult result = finishFrame(jobs[i], methods, segmenters, options, done);
        sorter.add(i, std::move(result.records));
      }
    } catch (...) {
      next = jobs.size();  // the other threads stop, too
      throw;
    }
  };
  onThreads(static_cast<int>(std::min<std::size_t>(std::max(options.jobs, 1), jobs.size())), work);
}

}  // namespace epcc
