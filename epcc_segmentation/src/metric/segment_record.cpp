// SPDX-License-Identifier: BSD-3-Clause
// Copies a clustered line's numbers and turns its end points into the caller's frame.
#include "metric/segment_record.h"

namespace epcc {

LineSegment lineSegmentOf(const DepthFrame& view, int column, const ClusteredLine& line) {
  LineSegment segment;
  segment.scan = view.isTransposed() ? ScanDirection::Rows : ScanDirection::Columns;
  segment.line = column;
  segment.first = line.first;
  segment.last = line.last;
  segment.samples = line.prototype.statistics.n;
  segment.start = view.fromScan(line.a);
  segment.end = view.fromScan(line.b);
  segment.mean = line.prototype.statistics.mean;
  segment.covariance = line.prototype.statistics.covariance;
  segment.variance = line.prototype.variance;
  return segment;
}

}  // namespace epcc
