// SPDX-License-Identifier: BSD-3-Clause
// Every so manieth value of a row.
#pragma once

namespace epcc {

/// to[i] = from[stride * i] for i in [0, count).
template <typename T>
void thinOut(const T* from, int count, int stride, T* to) {
  if (stride == 2)  // the compiler knows how to take every second one
    for (int i = 0; i < count; ++i) to[i] = from[2 * i];
  else
    for (int i = 0; i < count; ++i, from += stride) to[i] = *from;
}

}  // namespace epcc
