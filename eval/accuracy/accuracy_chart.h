// SPDX-License-Identifier: BSD-3-Clause
// The curve of docs/research/accuracy.md as a picture.
#pragma once

#include "eval/experiment/experiment_summary.h"
#include "eval/pictures/plot.h"

namespace epcc {

/// Surfaces correct against noise clusters, both per surface, as the curve's parameter grows: a line for each data set
/// of at least 20 surfaces; the parameter's default is marked, its first and last value are written where they differ.
Plot accuracyChart(const ExperimentSummary& curve);

}  // namespace epcc
