// SPDX-License-Identifier: BSD-3-Clause
// The runs behind docs/research/accuracy.md: sensors, data sets, their halves, their copies, a sequence, a curve, and
// rendered scenes.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "eval/accuracy/accuracy_methods.h"
#include "eval/accuracy/accuracy_sources.h"
#include "eval/experiment/experiment_summary.h"
#include "eval/experiment/sequence_repeatability.h"
#include "eval/report/table.h"

namespace epcc {

struct AccuracyOptions {
  std::string data;    ///< folder of the data sets
  std::string out;     ///< folder for the pictures
  int seeds = 2;       ///< of each rendered scene and noise, from seed 0
  int step_seeds = 5;  ///< of each step in depth
  int jobs = 1;        ///< frames at a time, where times count; else one a core
};

struct AccuracyResult {
  /// Every run, by data set and method; copies are called DATASET-COPY, scenes and steps as accuracy_sources.h says.
  ExperimentSummary all;
  /// The data sets' frames by sensorOf() instead of the data set.
  ExperimentSummary sensors;
  /// The data sets' frames 0, 2, 4 ... and 1, 3, 5 ... in the order of their names.
  std::array<ExperimentSummary, 2> halves;
  /// The data sets' frames by data set and value of the curve's parameter.
  ExperimentSummary curve;
  /// The first and the second half of the sequence.
  std::array<SequenceResult, 2> repeatability;
  /// The data sets' frames in the inverse-depth mode, given and measured sensor.
  std::vector<FrameRecord> frames;
  /// The steps' frames with the same two.
  std::vector<FrameRecord> steps;
  /// Every record as in epcc_eval's frames.csv.
  Table rows;
  /// Data sets that are missing, frames that could not be read or that EPCC failed on.
  std::vector<std::string> problems;
  /// Frames that another method failed on: the tables say how many.
  std::vector<std::string> failures;
};

/// Frames between two of a sequence that are compared.
std::vector<int> accuracyLags();

/// Called with the number of frames done and to do.
using AccuracyProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Runs everything. Leaves a picture of each original and rendered frame in OUT/overlays: depth, truth, the forms of
/// EPCC. A data set that is not there is one problem, and the rest is done. Throws OutputError.
AccuracyResult runAccuracy(const AccuracyOptions& options, const AccuracyProgress& progress = {});

}  // namespace epcc
