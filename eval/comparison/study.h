// SPDX-License-Identifier: BSD-3-Clause
// A study: variants of EPCC's parameters in a grid, all run on the same rendered frames.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "datasets/rendered/rendered_scenes.h"
#include "epcc_segmentation/parameters.h"
#include "eval/comparison/comparison.h"

namespace epcc {

/// One place in the grid of variants.
struct StudyVariant {
  std::string row;     ///< value of the rows' parameter; captions of the picture
  std::string column;  ///< value of the columns' parameter; empty in a grid with one column
  /// Parameters for a set of frames, given its name.
  std::function<Parameters(const std::string& frames)> parameters;
};

/// Frames of one kind.
struct StudyFrames {
  std::string name;
  RenderedFrames::Make make;
};

struct Study {
  std::string name;          ///< as on the command line and in the files' names
  std::string title;         ///< with the figure or table of the paper
  std::string frames_title;  ///< heading of the frames' names: "scene", "distance"
  std::string row_title;
  std::string column_title;            ///< empty in a grid with one column
  std::vector<StudyVariant> variants;  ///< row by row
  std::vector<StudyFrames> frames;
  std::string sensor = "d435i";  ///< sensor model told to EPCC, empty: that of the frame
  std::string noise_text;
  std::uint64_t first_seed = 0;
  int seeds = 10;
  /// A table row for every set of frames and variant; otherwise only their means.
  bool by_frames = false;
  /// Count the line segments of Algorithm 1 and the share of pixels in them.
  bool count_lines = false;
  /// Where by_frames is not set: the set of frames shown in the picture.
  std::string pictured;
};

/// One variant on one set of frames, or on the mean of all ("mean").
struct StudyRow {
  std::string frames;
  std::size_t variant = 0;
  Scores mean{};
  Scores deviation{};
  double lines = 0.0;       ///< line segments a scan line that has samples
  double line_share = 0.0;  ///< share of the measured pixels that lie in a line segment
};

struct StudyPicture {
  std::string frames;
  LabelledFrame frame;
  std::vector<PlaneSegmentation> segmentations;  ///< by variant
};

struct StudyResult {
  std::vector<StudyRow> rows;
  std::vector<StudyPicture> pictures;  ///< first seed of each set of frames
};

/// Runs every variant on every frame. Throws std::runtime_error if a variant fails.
StudyResult runStudy(const Study& study, int jobs, const ComparisonProgress& progress = {});

}  // namespace epcc
