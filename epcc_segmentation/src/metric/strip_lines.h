// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1 on the strips of a frame or of a stream: their line segments in double precision.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "metric/clustered_line.h"
#include "metric/line_clustering.h"

namespace epcc {

/// Where the numbers of a strip's samples go: segment k of its line i is first + k * step + i.
struct SegmentNumbers {
  std::int32_t first = 1;
  std::int32_t step = kStripLines;
  std::int32_t* numbers = nullptr;  ///< rows of kStripLines lines, `stride` apart
  std::size_t stride = 0;
};

/// The line segments of one strip after another, with the memory of one thread.
class StripLines {
 public:
  /// Segments that a scan line of so many samples can have.
  static int capacity(int height, const ClusteringRule& rule) { return height / rule.minSamples() + 1; }

  /// The first `lines` of the strip.
  void cluster(const ScanStrip& strip, const ClusteringRule& rule, const SegmentNumbers& numbers,
               int lines = kStripLines);
  /// Segments that were found in a line of the strip.
  int count(int line) const { return found_.count[line]; }
  /// Of a cloud: sum of the unit vectors (x, z) of t1 in the line.
  const float* directionSum(int line) const { return found_.direction[line]; }
  /// Those of a line; `direction` is the unit vector of its t1 in the scan frame.
  void list(int line, const Eigen::Vector3d& direction, std::vector<ClusteredLine>& segments) const;

 private:
  std::vector<LineRecord> records_;
  LineWorkspace workspace_;
  StripSegments found_;
};

}  // namespace epcc
