// SPDX-License-Identifier: BSD-3-Clause
// The samples of one row in an earlier frame, in vectors.
#pragma once

#include <cstdint>

namespace epcc {

/// How a row of samples is carried. A sample's point times its inverse depth is begin + along_row * across + shift * w,
/// its pixel in the earlier frame offset + factor * x / z, rounded down.
struct CarriedRow {
  const float* w;
  const float* across;
  int width;
  float along;
  float begin[3], along_row[3], shift[3];
  float column_offset, column_factor, row_offset, row_factor;
  std::int32_t frame_width, frame_height;
};

/// pixels[k] = the pixel of the earlier frame (row * width + column) that shows what the sample shows, or the one
/// behind its last. Room for 16 more than the width.
void placesInEarlierFrame(const CarriedRow& row, std::int32_t* pixels);

}  // namespace epcc
