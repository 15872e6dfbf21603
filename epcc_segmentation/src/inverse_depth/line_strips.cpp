// SPDX-License-Identifier: BSD-3-Clause
// Columns lie side by side in the image, rows are put so; a strip that is not full is filled up with invalid samples.
#include "inverse_depth/line_strips.h"

#include <algorithm>

#include "vector/transpose.h"

namespace epcc {

namespace {

constexpr std::size_t kPitch = ScanLines::kCount;

void copyColumns(const float* from, std::size_t pitch, int count, int length, float* to) {
  for (int i = 0; i < length; ++i, from += pitch, to += kPitch) std::copy(from, from + count, to);
}

}  // namespace

void LineStrips::begin(const InverseDepthImage& image, const InverseDepthParameters& parameters) {
  scan_lines_ = columns_ ? image.width : image.height;
  length_ = columns_ ? image.height : image.width;
  capacity_ = LineGrowing(parameters).mostLines(length_);
  const std::vector<double>& x = columns_ ? image.along : image.across;
  x_.resize(x.size());
  std::transform(x.begin(), x.end(), x_.begin(), [](double value) { return static_cast<float>(value); });
  lines_.resize(static_cast<std::size_t>(scan_lines_) * static_cast<std::size_t>(capacity_));
  line_count_.resize(static_cast<std::size_t>(strips()) * ScanLines::kCount);
  segment_of_.resize(image.w.size());
}

void LineStrips::makeRoom(StripMemory& memory) const {
  const std::size_t samples = std::max(memory.w.size(), static_cast<std::size_t>(std::max(1, length_)));
  memory.w.resize(samples);
  memory.weight.resize(samples);
  memory.segment.resize(samples);
  memory.growing.makeRoom(length_);
}

// Where a tracker has explained all samples nothing is grown.
bool LineStrips::isEmpty(const InverseDepthImage& image, int first, int count) const {
  const auto width = static_cast<std::size_t>(image.width);
  const auto skip = static_cast<std::size_t>(first), lines = static_cast<std::size_t>(count);
  const float* w = image.w.data() + (columns_ ? skip : skip * width);
  const std::size_t rows = columns_ ? static_cast<std::size_t>(image.height) : lines, run = columns_ ? lines : width;
  for (std::size_t row = 0; row < rows; ++row, w += width)
    if (std::any_of(w, w + run, [](float value) { return value > 0.0f; })) return false;
  return true;
}

void LineStrips::leaveEmpty(int first, int count, std::size_t width) {
  std::fill_n(line_count_.begin() + first, ScanLines::kCount, 0);
  std::int32_t* segment = segment_of_.data() + static_cast<std::size_t>(first) * (columns_ ? 1 : width);
  const std::size_t rows = static_cast<std::size_t>(columns_ ? length_ : count);
  for (std::size_t row = 0; row < rows; ++row, segment += width)
    std::fill_n(segment, columns_ ? static_cast<std::size_t>(count) : width, -1);
}

void LineStrips::grow(const InverseDepthImage& image, int strip, StripMemory& memory) {
  const int first = strip * ScanLines::kCount;
  const int count = std::min(ScanLines::kCount, scan_lines_ - first);
  const auto width = static_cast<std::size_t>(image.width);
  if (isEmpty(image, first, count)) {
    leaveEmpty(first, count, width);
    return;
  }
  const std::size_t start = static_cast<std::size_t>(first) * (columns_ ? 1 : width);
  const bool in_place = columns_ && count == ScanLines::kCount;
  ScanLines scan_lines;
  scan_lines.x = x_.data();
  scan_lines.length = length_;
  scan_lines.lines = lines_.data() + static_cast<std::size_t>(first) * static_cast<std::size_t>(capacity_);
  scan_lines.capacity = capacity_;
  scan_lines.line_count = line_count_.data() + first;
  if (in_place) {
    scan_lines.w = image.w.data() + start;
    scan_lines.weight = image.weight.data() + start;
    scan_lines.pitch = width;
    scan_lines.segment = segment_of_.data() + start;
    memory.growing.grow(scan_lines);
    return;
  }

  const auto samples = static_cast<std::size_t>(std::max(1, length_));
  makeRoom(memory);
  float* w = memory.w.front().values;
  float* weight = memory.weight.front().values;
  std::int32_t* segment = memory.segment.front().values;
  if (count < ScanLines::kCount) {
    std::fill(w, w + samples * kPitch, 0.0f);
    std::fill(weight, weight + samples * kPitch, 1.0f);
  }
  if (columns_) {
    copyColumns(image.w.data() + start, width, count, length_, w);
    copyColumns(image.weight.data() + start, width, count, length_, weight);
  } else {
    transpose(image.w.data() + start, width, count, length_, w, kPitch);
    transpose(image.weight.data() + start, width, count, length_, weight, kPitch);
  }
  scan_lines.w = w;
  scan_lines.weight = weight;
  scan_lines.pitch = kPitch;
  scan_lines.segment = segment;
  memory.growing.grow(scan_lines);

  std::int32_t* segment_of = segment_of_.data() + start;
  if (columns_)
    for (int i = 0; i < length_; ++i, segment += kPitch, segment_of += width)
      std::copy(segment, segment + count, segment_of);
  else
    transpose(segment, kPitch, length_, count, segment_of, width);
}

}  // namespace epcc
