// SPDX-License-Identifier: BSD-3-Clause
// The lines that a method finds in a scan of a floor plan, against the truth.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "datasets/rendered/floor_plan.h"
#include "eval/measures/segcomp_measures.h"

namespace epcc {

/// Faces that fewer beams hit are not asked for, and whoever finds them is not blamed.
constexpr int kFewestFaceBeams = 9;

/// A line as any method gives it.
struct ScoredLine {
  double alpha = 0.0, rho = 0.0;
  std::optional<LaserLine> line;  ///< with uncertainty, where the method has one
};

/// Sums over scans.
struct LineScores {
  long faces = 0;  ///< that nine beams or more hit
  long lines = 0;
  SegcompMeasures regions;  ///< at 80 % overlap of the beams
  /// Of lines most of whose beams are on one face, and which have most of the face's.
  std::vector<double> angle_errors;     ///< rad, absolute
  std::vector<double> distance_errors;  ///< metres, of the line from the middle of what is seen, absolute
  std::vector<double> line_nees;        ///< squared errors of (alpha, rho) by their covariance
  std::vector<double>
      clear_line_nees;             ///< those of lines whose direction is known to 50 mrad, which errors hardly bend
  std::vector<double> end_errors;  ///< metres, both ends
  std::vector<double> end_nees;    ///< squared errors of end points by their covariance
  double seconds = 0.0;
  long scans = 0;

  LineScores& operator+=(const LineScores& other);
};

/// Scores one scan. `labels` as in LaserLines, lines[k - 1] being that of label k.
LineScores scoreLines(const FloorScan& truth, const std::vector<std::int32_t>& labels,
                      const std::vector<ScoredLine>& lines);

}  // namespace epcc
