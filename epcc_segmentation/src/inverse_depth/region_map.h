// SPDX-License-Identifier: BSD-3-Clause
// Labelled regions with their moments, the state that steps S3 to S8 work on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/plane_moments.h"
#include "inverse_depth/row_sums.h"

namespace epcc {

/// What regions gain and lose by pixels that change hands. Keeps its memory.
class MomentMoves {
 public:
  /// No region has gained or lost anything.
  void begin(std::size_t regions) { gains_.assign(regions + 1, RaySums()); }
  /// A pixel goes from one label to another; 0 is none.
  void move(const InverseDepthImage& image, int row, int column, std::int32_t from, std::int32_t to);
  /// Per label.
  const std::vector<RaySums>& gains() const { return gains_; }

 private:
  std::vector<RaySums> gains_;
};

/// Labels are row-major, 0 = none; regions[k - 1] belongs to label k, n = 0 marks a dropped region.
struct RegionMap {
  std::vector<std::int32_t> labels;
  std::vector<PlaneMoments> regions;
  std::vector<double> confidence;  ///< per region, of S9
  /// The first so many regions are of planes known before (KnownRegions), some of them empty: they do not join each
  /// other and are not rejected.
  int known = 0;
  std::vector<std::uint8_t> doubtful;  ///< per known region after S7: it would have been rejected
  std::vector<int> known_plane;        ///< per region after S9: the known plane that it continues, or -1
  MomentMoves moves;
  std::vector<RaySums> sums;  ///< memory of accumulate(), band by band

  /// Recomputes every region's moments from the labels.
  void accumulate(const InverseDepthImage& image, int threads = 1);
  /// Adds what `moves` holds to the moments: for a few pixels it takes a fraction of accumulate()'s time.
  void applyMoves(const InverseDepthImage& image);
  /// Gives every pixel of label k the label new_label[k]; regions are left as they are.
  void relabel(const std::vector<std::int32_t>& new_label, int threads = 1);
};

}  // namespace epcc
