// SPDX-License-Identifier: BSD-3-Clause
// Methods for the lines of laser scans, compared on floor plans.
#pragma once

#include <string>
#include <vector>

#include "epcc_segmentation/laser_line_extractor.h"
#include "eval/line_study/line_scores.h"
#include "eval/lines/line_map.h"

namespace epcc {

struct LineStudyOptions {
  int plans = 10;                 ///< seeds 0, 1, ...
  int scans = 30;                 ///< of each plan
  double split_distance = 0.05;   ///< of a point from its line, metres
  double ransac_distance = 0.03;  ///< the same
  LaserLineParameters parameters;
};

struct LineStudyRow {
  std::string sensor, method;
  LineScores scores;
};

/// Every method on every scan of two sensors: half a degree all round, one degree over half a circle.
std::vector<LineStudyRow> runLineStudy(const LineStudyOptions& options);

/// The tables of docs/research/laser_lines.md.
std::string lineStudyTables(const std::vector<LineStudyRow>& rows);

/// The lines of scans of one floor plan, in its frame.
LineMap floorMap(const LineStudyOptions& options);

}  // namespace epcc
