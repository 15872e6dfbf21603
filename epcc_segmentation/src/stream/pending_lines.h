// SPDX-License-Identifier: BSD-3-Clause
// Scan lines of a stream whose labels are not certain yet, in a queue that keeps its memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "point_moments.h"

namespace epcc {

/// A line segment that waits for its plane.
struct PendingSegment {
  static constexpr int kNone = -1;
  int plane = kNone;  ///< place in the list of planes
  PointMoments moments;
};

/// Neighbouring samples of one segment.
struct PendingRun {
  std::int32_t first, last;
  std::int32_t segment;
};

struct PendingLine {
  std::int64_t index = 0;
  double azimuth = 0.0;
  std::int64_t serial = 0;  ///< counts the lines that Algorithm 2 was fed
  std::vector<PendingSegment> segments;
  std::vector<PendingRun> runs;
};

/// First in, first out. What is taken out keeps its memory for what comes.
template <typename T>
class RecyclingQueue {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& at(std::size_t i) { return places_[(first_ + i) % places_.size()]; }
  T& front() { return places_[first_]; }
  /// What an earlier one left in it is to be overwritten.
  T& push() {
    if (size_ == places_.size()) grow();
    return at(size_++);
  }
  void pop() {
    first_ = (first_ + 1) % places_.size();
    --size_;
  }
  void clear() { size_ = 0; }

 private:
  void grow() {
    std::vector<T> larger(places_.empty() ? 16 : 2 * places_.size());
    for (std::size_t i = 0; i < size_; ++i) std::swap(larger[i], at(i));
    places_.swap(larger);
    first_ = 0;
  }

  std::vector<T> places_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace epcc
