// SPDX-License-Identifier: BSD-3-Clause
// One row of the image as the kernel of S3 wants it.
#pragma once

#include <cstdint>
#include <limits>

namespace epcc {

constexpr std::uint32_t kNoPlane = std::numeric_limits<std::uint32_t>::max();  // a rank; the label is one more

/// Segments are numbers within their scan lines, -1 none; a direction that is not active has null ones.
struct JoinedRow {
  int width = 0;
  const std::int32_t* column_segment = nullptr;
  const std::int32_t* column_first = nullptr;  // per column: the place in column_rank of its segment 0
  const std::uint32_t* column_rank = nullptr;
  std::int32_t* known_segment = nullptr;  // per column: the last segment, -1 at first
  std::uint32_t* known_rank = nullptr;    // and its rank
  const std::int32_t* row_segment = nullptr;
  const std::uint32_t* row_rank = nullptr;  // of the row's segment 0; of none before it
  std::int32_t* label = nullptr;
};

}  // namespace epcc
