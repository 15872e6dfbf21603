// SPDX-License-Identifier: BSD-3-Clause
// S1 over an image, in strips of adjacent columns or rows that know nothing of each other.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/line_growing.h"

namespace epcc {

/// What one thread needs to grow a strip: S1's memory, and samples side by side where they do not lie so in the image.
struct StripMemory {
  LineGrowing growing{InverseDepthParameters()};
  std::vector<ValuesOfLines<float>> w, weight;
  std::vector<ValuesOfLines<std::int32_t>> segment;
};

/// The line segments of all columns, or of all rows, of an image.
class LineStrips {
 public:
  explicit LineStrips(bool columns) : columns_(columns) {}

  /// Makes room for the segments of an image.
  void begin(const InverseDepthImage& image, const InverseDepthParameters& parameters);
  int strips() const { return (scan_lines_ + ScanLines::kCount - 1) / ScanLines::kCount; }
  /// For any strip of the image; grow() does it, too.
  void makeRoom(StripMemory& memory) const;
  /// Each strip writes to places of its own.
  void grow(const InverseDepthImage& image, int strip, StripMemory& memory);

  int scanLines() const { return scan_lines_; }
  int lineCount(int scan_line) const { return line_count_[static_cast<std::size_t>(scan_line)]; }
  const GrownLine* lines(int scan_line) const {
    return lines_.data() + static_cast<std::size_t>(scan_line) * static_cast<std::size_t>(capacity_);
  }
  /// Per pixel, row-major: the number of its segment within its scan line, -1 none.
  const std::vector<std::int32_t>& segmentOf() const { return segment_of_; }

 private:
  bool isEmpty(const InverseDepthImage& image, int first, int count) const;
  void leaveEmpty(int first, int count, std::size_t width);

  bool columns_;
  int scan_lines_ = 0;
  int length_ = 0;
  int capacity_ = 0;
  std::vector<float> x_;  // per sample of a scan line: its ray coordinate
  std::vector<GrownLine> lines_;
  std::vector<std::int32_t> line_count_;
  std::vector<std::int32_t> segment_of_;
};

}  // namespace epcc
