// SPDX-License-Identifier: BSD-3-Clause
// The runs behind docs/research/accuracy.md: the data sets, their halves, their copies, and rendered scenes.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "eval/experiment/experiment_summary.h"
#include "eval/report/table.h"

namespace epcc {

/// The inverse-depth mode with the sensor measured on the frame, beside the methods of segmenterNames().
constexpr const char* kAutoMethod = "epcc-auto";

struct AccuracyOptions {
  std::string data;    ///< folder of the data sets
  std::string out;     ///< folder for the pictures
  int seeds = 2;       ///< of each rendered scene and noise, from seed 0
  int step_seeds = 5;  ///< of each step in depth
  int jobs = 1;        ///< frames at a time
};

/// Data sets that the page is made of, folders of AccuracyOptions::data; "synpeb" holds spherical scans.
std::vector<std::string> accuracyDatasets();
/// Noise laid on the rendered scenes, as parseNoise() takes it.
std::vector<std::string> accuracyNoises();
/// A step in depth seen by a sensor; see eval/step_frames.h.
struct AccuracyStep {
  std::string scene;   ///< door, frame
  std::string sensor;  ///< preset
  double metres;
};
std::vector<AccuracyStep> accuracySteps();
/// Name of the data set of a step, for example "door-realsense-100": millimetres.
std::string stepDataset(const AccuracyStep& step);
/// Name of the data set of a scene with a noise, for example "a-stereo".
std::string sceneDataset(const std::string& scene, const std::string& noise);
/// epcc, epcc-auto and the rest of segmenterNames().
std::vector<std::string> accuracyMethods();

struct AccuracyResult {
  /// Every run, by data set and method; copies are called DATASET-COPY, scenes and steps as the
  /// functions above say.
  ExperimentSummary all;
  /// The data sets' frames 0, 2, 4 ... and 1, 3, 5 ... in the order of their names.
  std::array<ExperimentSummary, 2> halves;
  /// The data sets' frames in the inverse-depth mode, given and measured sensor one after the other.
  std::vector<FrameRecord> frames;
  /// The steps' frames with the same two.
  std::vector<FrameRecord> steps;
  /// Every record as in epcc_eval's frames.csv.
  Table rows;
  /// Data sets that are missing, frames that could not be scored.
  std::vector<std::string> problems;
};

/// Called with the number of frames done and to do.
using AccuracyProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Runs everything. Leaves a picture of each original and rendered frame in OUT/overlays: depth, truth, the three forms
/// of EPCC. A data set that is not there is one problem, and the rest is done. Throws OutputError.
AccuracyResult runAccuracy(const AccuracyOptions& options, const AccuracyProgress& progress = {});

}  // namespace epcc
