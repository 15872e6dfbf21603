// SPDX-License-Identifier: BSD-3-Clause
// Columns of a scanner whose rings look at different azimuths -> scan lines of one azimuth.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/stream_geometry.h"
#include "stream/given_line.h"

namespace epcc {

/// Keeps the points of the last columns until their scan lines are complete: as many columns as the rings are apart.
/// A scan line has its place in the count of columns, so that ring k of line i came with column i + ringShift(k). All
/// memory is taken by begin().
class StaggeredRings {
 public:
  void begin(const StreamGeometry& geometry);
  /// Ranges of a column, whose index is behind that of the last one; work(const GivenLine&) is called with each scan
  /// line that no coming column adds to, in order: points x, y, z in the sensor's frame, NaN where nothing is measured.
  /// Lines without a column are left out.
  template <typename Work>
  void add(const GivenLine& column, const Work& work) {
    const std::int64_t completed = column.index - most_;
    handOut(completed, work);
    next_ = completed;  // what lies between is lost, or the stream begins
    write(column);
    handOut(completed + 1, work);
  }
  /// No column is to come: the same with all scan lines that are left.
  template <typename Work>
  void finish(const Work& work) {
    handOut(end_, work);
    next_ = end_ = 0;
  }

 private:
  struct Line {
    bool has_column = false;
    double azimuth = 0.0;  // NaN: not known yet
  };
  std::size_t place(std::int64_t index) const {
    const auto count = static_cast<std::int64_t>(lines_.size());
    return static_cast<std::size_t>((index % count + count) % count);
  }
  float* points(std::size_t place) { return points_.data() + place * 3 * shift_.size(); }
  void write(const GivenLine& column);
  void clear(std::size_t place);

  /// Those before `end`.
  template <typename Work>
  void handOut(std::int64_t end, const Work& work) {
    for (end = std::min(end, end_); next_ < end; ++next_) {
      const std::size_t at = place(next_);
      if (lines_[at].has_column) work(GivenLine{next_, lines_[at].azimuth, points(at), 3});
      clear(at);
    }
  }

  double azimuth_step_ = 0.0;
  std::vector<int> shift_;                        // of the rings
  int least_ = 0, most_ = 0;                      // of the shifts
  std::vector<double> cosine_, sine_;             // of the rings' elevations ...
  std::vector<double> cosine_ahead_, sine_left_;  // ... and of their azimuths
  std::vector<Line> lines_;                       // at place(index)
  std::vector<float> points_;                     // of these lines
  std::int64_t next_ = 0, end_ = 0;  // first line that is not handed out, and behind the last with a column
};

}  // namespace epcc
