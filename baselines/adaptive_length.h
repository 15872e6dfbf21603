// SPDX-License-Identifier: BSD-3-Clause
// Lengths that are given in metres or follow the resolution of the frame.
#pragma once

#include <string>

namespace epcc {

/// A length of a baseline: fixed in metres, as in the paper's Table 3, or in multiples of the distance between the
/// points of neighbouring pixels, so that one set of parameters serves a range camera of half a millimetre's
/// resolution at 1 m as well as a corridor ten metres deep.
struct AdaptiveLength {
  double metres = 0.0;  ///< Fixed length, (0, 100] m; used where pixels is 0.
  double pixels = 0.0;  ///< Multiple of the frame's median point distance (medianSpacing()), [0, 1000]; 0: fixed.

  /// The length in metres for a frame with this point distance in metres.
  double at(double spacing) const { return pixels > 0.0 ? pixels * spacing : metres; }

  /// Empty if usable, else what is wrong with the length called `name`, in words.
  std::string validate(const std::string& name) const {
    if (!(pixels >= 0.0 && pixels <= 1000.0)) return name + " must be in [0, 1000] pixels";
    if (pixels == 0.0 && !(metres > 0.0 && metres <= 100.0)) return name + " must be in (0, 100] m";
    return {};
  }
};

}  // namespace epcc
