// SPDX-License-Identifier: BSD-3-Clause
// IoU, Dice, precision and recall of the surfaces that a cluster matches, and the share of pixels well labelled.
#pragma once

#include <cstddef>
#include <vector>

#include "eval/measures/overlap_table.h"

namespace epcc {

/// A surface and the cluster it is matched with, as rows and columns of the table.
struct InstanceMatch {
  std::size_t surface = 0;
  std::size_t cluster = 0;
  double iou = 0.0;   ///< O / (|c| + |g| - O)
  double dice = 0.0;  ///< 2 O / (|c| + |g|)
};

/// Pairs with IoU >= 0.5, one to one, by surface; of two equal clusters the first.
std::vector<InstanceMatch> matchInstances(const OverlapTable& table);

/// Counts of one frame or, added up, of many. Sums of ratios are kept in whole millionths, so that they do not
/// depend on the order of the frames.
struct InstanceMeasures {
  long surfaces = 0;
  long clusters = 0;
  long matched = 0;
  long iou_millionths = 0;    ///< summed over the matched surfaces
  long dice_millionths = 0;   ///< summed over the matched surfaces
  long plane_pixels = 0;      ///< scored pixels of all surfaces
  long dominated_pixels = 0;  ///< those of them in a cluster dominated by their surface

  /// Ratios; NaN where there is nothing to divide by.
  double precision() const;
  double recall() const;
  double meanIou() const;
  double meanDice() const;
  double coverage() const;

  InstanceMeasures& operator+=(const InstanceMeasures& other);
};

InstanceMeasures instanceMeasures(const OverlapTable& table);

}  // namespace epcc
