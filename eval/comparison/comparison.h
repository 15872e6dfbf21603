// SPDX-License-Identifier: BSD-3-Clause
// The paper's comparison (Table 4, Fig. 21) on rendered surrogates of its four scenes.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "datasets/files/labelled_frame.h"
#include "datasets/noise/sensor_noise.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "eval/comparison/published_table4.h"
#include "eval/experiment/score_statistics.h"

namespace epcc {

/// Said wherever the table appears.
constexpr const char* kSurrogateNote =
    "The scenes are rendered surrogates: the authors' labelled D435i scenes are not public. The published values were "
    "measured on the authors' scenes, not on these.";

/// Which parameters the methods get.
enum class ParameterSet {
  Paper,   ///< Table 3; epcc-paper is given the paper's noise model (Eq. 22, preset d435i)
  Default  ///< the project's own; every method is given the sensor model that the frame names
};

struct ComparisonOptions {
  std::vector<std::string> scenes{"a", "b", "c", "d"};
  ParameterSet parameters = ParameterSet::Paper;
  NoiseOptions noise;                 ///< added to the rendered depth
  std::string noise_text = "stereo";  ///< the same in words
  std::uint64_t first_seed = 0;
  int seeds = 20;       ///< for EPCC
  int slow_seeds = 10;  ///< for region growing and RANSAC
  int jobs = 2;         ///< threads
};

/// One method on one scene, or on the mean of all scenes (scene "mean", deviation that of the seeds' means).
struct ComparisonRow {
  std::string scene;
  std::string method;
  int seeds = 0;
  double surfaces = 0.0;  ///< N
  Scores mean{};
  Scores deviation{};
  double median_ms = 0.0;
  std::optional<PublishedScores> published;
};

/// The first seed of a scene, for the picture.
struct ComparedFrame {
  std::string scene;
  LabelledFrame frame;
  std::map<std::string, PlaneSegmentation> segmentations;  ///< by method
};

struct Comparison {
  std::vector<ComparisonRow> rows;  ///< scene by scene in the order of comparedMethods(), then the means
  std::vector<ComparedFrame> frames;
};

/// region-growing, ransac, epcc-paper, epcc.
std::vector<std::string> comparedMethods();

/// Called with the number of frames done and to do, counted once a group of methods.
using ComparisonProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Runs everything. Throws std::invalid_argument for an unknown scene or fewer than one seed, std::runtime_error if a
/// method fails on a frame.
Comparison runComparison(const ComparisonOptions& options, const ComparisonProgress& progress = {});

}  // namespace epcc
