// SPDX-License-Identifier: BSD-3-Clause
// Parameters that are changed step by step, as with a dial.
#pragma once

#include <string>
#include <vector>

#include "epcc_segmentation/parameter_table.h"

namespace epcc {

/// The basic parameters of the mode, scan first: those of docs/reference/parameters.md that are no expert's.
std::vector<const ParameterField*> dialFields(Mode mode);

/// The value one step up (`direction` 1) or down (-1), within the field's range. Steps are about a tenth of a number,
/// round numbers follow each other (1.5, 1.6 ... 2, 2.2 ...), 0 is reached where the range has it; choices go round.
double dialStep(const ParameterField& field, double value, int direction);

}  // namespace epcc
