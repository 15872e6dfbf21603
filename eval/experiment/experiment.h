// SPDX-License-Identifier: BSD-3-Clause
// Runs methods over frames and scores them, on several threads, with results in a fixed order.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "baselines/registry.h"
#include "datasets/sources/reading_options.h"
#include "eval/experiment/frame_jobs.h"
#include "eval/measures/frame_measures.h"

namespace epcc {

/// A method of the comparison; every thread makes its own segmenter.
struct Method {
  std::string name;
  std::function<std::unique_ptr<PlaneSegmenter>()> make;
  bool timed = true;  ///< false: its time means nothing (imported labels)
};

/// A method of segmenterNames(); throws std::invalid_argument for another name.
Method registeredMethod(const std::string& name, const SegmenterOptions& options = defaultParameters());
/// Label images in a folder, see ImportedLabelsSegmenter.
Method importedMethod(const std::string& name, const std::string& folder);

/// What one method did on one frame.
struct FrameRecord {
  std::string dataset;
  std::string frame;
  std::string method;
  FrameMeasures measures;    ///< all zero after an error
  std::optional<double> ms;  ///< time of the method; nothing after an error and for imported labels
  std::string error;         ///< empty if the frame was scored
  std::string doubt = {};    ///< what makes the result doubtful although the frame was scored; empty: nothing
};

/// A frame with everything that was done to it; records and segmentations in the order of the methods.
struct FrameResult {
  std::size_t index = 0;  ///< in its source
  std::string file_name;
  LabelledFrame frame;  ///< empty after a reading error
  std::vector<FrameRecord> records;
  std::vector<PlaneSegmentation> segmentations;  ///< empty after a reading error
  std::string reading_error;                     ///< also in each record
  bool lost = false;  ///< its process was ended, and may have left files half written under temporary names
};

struct ExperimentOptions {
  std::string noise;  ///< sensor model, as frameSensor() takes it; empty: the frame's "noise", else auto
  int jobs = 1;       ///< threads, at least 1
  ReadingOptions reading = {};
  double frame_timeout = 0.0;  ///< seconds for a frame, everything included; 0: no limit. See timed_experiment.h
};

using Segmenters = std::vector<std::unique_ptr<PlaneSegmenter>>;
Segmenters makeSegmenters(const std::vector<Method>& methods);

/// Reads a frame and runs every method on it. Errors end up in the records; nothing is thrown.
FrameResult evaluateFrame(const FrameJob& job, const std::vector<Method>& methods, const Segmenters& segmenters,
                          const ExperimentOptions& options);
/// The frame with an error for every method.
FrameResult failedFrame(const FrameJob& job, const std::vector<Method>& methods, const std::string& error);

/// Called as soon as a frame is done, by several threads or processes at once: for writing its files. What it throws
/// ends the run.
using FrameDone = std::function<void(const FrameResult&)>;
/// evaluateFrame() and `done`. A frame that there is not enough memory to write is one that could not be read.
FrameResult finishFrame(const FrameJob& job, const std::vector<Method>& methods, const Segmenters& segmenters,
                        const ExperimentOptions& options, const FrameDone& done);
/// Called in the order of the jobs, by one thread at a time.
using FrameInOrder = std::function<void(const std::vector<FrameRecord>&)>;

/// Does all jobs. Either function may be empty.
void runExperiment(const FrameJobs& jobs, const std::vector<Method>& methods, const ExperimentOptions& options,
                   const FrameDone& done, const FrameInOrder& in_order);

}  // namespace epcc
