// SPDX-License-Identifier: BSD-3-Clause
// Labels of other programs, whose numbers may be anything.
#pragma once

#include <cstdint>
#include <vector>

namespace epcc {

/// Labels of 1 .. label_count become 1, 2, 3, ... in their order without gaps, any other 0; how many there are. Takes
/// memory for the pixels, however large the numbers are.
int closeLabels(int label_count, std::vector<std::int32_t>& labels);

}  // namespace epcc
