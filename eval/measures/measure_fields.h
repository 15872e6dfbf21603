// SPDX-License-Identifier: BSD-3-Clause
// The whole numbers of FrameMeasures by name: the columns of the reports, the keys of the stored results.
#pragma once

#include <vector>

#include "eval/measures/frame_measures.h"

namespace epcc {

/// A name and where its number is.
struct MeasureField {
  const char* name;
  long& (*of)(FrameMeasures&);
};

/// The counts of summary.json, in its order.
const std::vector<MeasureField>& countFields();
/// Sums that frames.csv has beside them: with them every ratio of the summary can be made from the frames.
const std::vector<MeasureField>& furtherFields();

inline long valueOf(const MeasureField& field, const FrameMeasures& measures) {
  return field.of(const_cast<FrameMeasures&>(measures));
}

}  // namespace epcc
