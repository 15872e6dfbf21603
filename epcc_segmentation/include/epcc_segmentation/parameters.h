// SPDX-License-Identifier: BSD-3-Clause
// Everything that steers a segmentation but the sensor model. Every field is listed with its range, unit and effect in
// parameter_table.h, which validate(), the command line and docs/reference/parameters.md use.
#pragma once

#include <string>

#include "epcc_segmentation/export.h"
#include "epcc_segmentation/inverse_depth_parameters.h"
#include "epcc_segmentation/paper_parameters.h"

namespace epcc {

/// The two forms of the method.
enum class Mode {
  InverseDepth,  ///< planes in inverse depth, made for the correlated error of real sensors
  Paper          ///< metric sections, Algorithms 1 and 2 as published
};

/// Which lines of the image are the scan lines (Sec. 7.2).
enum class ScanDirection {
  Columns,  ///< the columns alone
  Rows,     ///< the rows alone; an error for spherical scans
  Both      ///< all that the mode and the frame allow: the paper mode and spherical scans have columns alone
};

/// Parameters of both modes; a mode reads its own.
struct Parameters {
  /// Form of the method. inverse-depth | paper, default inverse-depth. Choose paper to compare with the publication.
  Mode mode = Mode::InverseDepth;

  /// Scan lines. columns | rows | both, default both. Choose one direction to save time; rows are an error for
  /// spherical scans, whose rows are cones.
  ScanDirection scan = ScanDirection::Both;

  /// Threads; the result does not depend on them. [1, 256] threads, default 1. Raise it if cores are idle; lower it if
  /// other work needs them.
  int threads = 1;

  /// Report the line segments too (PlaneSegmentation::segments). off | on, default off. Choose on to draw them, or to
  /// build something else than planes on them.
  bool line_segments = false;

  InverseDepthParameters inverse_depth;  ///< what Mode::InverseDepth reads
  PaperParameters paper;                 ///< what Mode::Paper reads

  /// Parameters of the paper mode with its defaults.
  EPCC_CORE_EXPORT static Parameters forPaper();

  /// Empty if every value is in its range, else the first thing that is wrong, in words.
  EPCC_CORE_EXPORT std::string validate() const;
};

}  // namespace epcc
