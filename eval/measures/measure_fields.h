// SPDX-License-Identifier: BSD-3-Clause
// The whole numbers of FrameMeasures by name: the columns of the reports, the keys of the stored results.
#pragma once

#include <vector>

#include "eval/measures/frame_measures.h"

namespace epcc {

/// A name, and the number that it stands for: to be written and to be read.
struct MeasureField {
  const char* name;
  long& (*of)(FrameMeasures&);
  long (*value)(const FrameMeasures&);
};

/// The counts of summary.json, in its order.
const std::vector<MeasureField>& countFields();
/// Sums that frames.csv has beside them: with them every ratio of the summary can be made from the frames.
const std::vector<MeasureField>& furtherFields();

}  // namespace epcc
