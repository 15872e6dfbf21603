// SPDX-License-Identifier: BSD-3-Clause
// Values go to as many buckets as there are, which leaves little to order.
#include "sensor/ordered_values.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace epcc {

namespace {

constexpr int kFewInBucket = 16;

}  // namespace

void orderValues(float* values, int count) {
  assert(count >= 0 && count <= kMaxOrdered);
  if (count < 2) return;
  const Eigen::Map<const Eigen::ArrayXf> all(values, count);
  const float least = all.minCoeff();
  const float range = all.maxCoeff() - least;
  const float buckets_per_value = static_cast<float>(count - 1) / range;
  if (!(range > 0.0f)) return;
  if (!std::isfinite(range) || !std::isfinite(buckets_per_value)) {  // absurd values
    std::sort(values, values + count);
    return;
  }
  std::array<int, kMaxOrdered> bucket;
  std::array<int, kMaxOrdered> place;  // of the next value of a bucket
  std::array<float, kMaxOrdered> sorted;
  for (int i = 0; i < count; ++i) bucket[i] = static_cast<int>((values[i] - least) * buckets_per_value);
  std::fill(place.begin(), place.begin() + count, 0);
  for (int i = 0; i < count; ++i) ++place[bucket[i]];
  int before = 0;
  int most = 0;
  for (int b = 0; b < count; ++b) {
    const int size = place[b];
    place[b] = before;
    before += size;
    most = std::max(most, size);
  }
  for (int i = 0; i < count; ++i) sorted[place[bucket[i]]++] = values[i];
  if (most > kFewInBucket)
    for (int b = 0, first = 0; b < count; first = place[b++])
      if (place[b] - first > kFewInBucket) std::sort(sorted.begin() + first, sorted.begin() + place[b]);
  // Within the buckets by insertion, for between them they are in order.
  values[0] = sorted[0];
  for (int i = 1; i < count; ++i) {
    const float value = sorted[i];
    int at = i;
    for (; at > 0 && values[at - 1] > value; --at) values[at] = values[at - 1];
    values[at] = value;
  }
}

}  // namespace epcc
