// SPDX-License-Identifier: BSD-3-Clause
// Which regions may be one surface: neighbours in the image, and regions seen on both sides of an occluder.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "inverse_depth/region_map.h"

namespace epcc {

/// Two labels, low < high.
struct RegionPair {
  std::int32_t low, high;
  RegionPair(std::int32_t a, std::int32_t b) : low(a < b ? a : b), high(a < b ? b : a) {}
  bool operator==(const RegionPair& other) const { return low == other.low && high == other.high; }
  struct Hash {
    std::size_t operator()(const RegionPair& pair) const {
      return std::hash<std::uint64_t>()((static_cast<std::uint64_t>(static_cast<std::uint32_t>(pair.high)) << 32) |
                                        static_cast<std::uint32_t>(pair.low));
    }
  };
};

template <typename Value>
using RegionPairs = std::unordered_map<RegionPair, Value, RegionPair::Hash>;

/// Looks pairs up, new ones too. Borders come in runs, so the pair before is tried first.
template <typename Value>
class RegionPairLookup {
 public:
  explicit RegionPairLookup(RegionPairs<Value>& pairs) : pairs_(pairs) {}
  Value& operator[](const RegionPair& pair) {
    if (value_ == nullptr || !(pair == last_)) {
      last_ = pair;
      value_ = &pairs_[pair];  // stays where it is when others are added
    }
    return *value_;
  }

 private:
  RegionPairs<Value>& pairs_;
  RegionPair last_{0, 0};
  Value* value_ = nullptr;
};

/// Where two regions meet.
struct Contact {
  int count = 0;                                   ///< places
  Eigen::Matrix3d rays = Eigen::Matrix3d::Zero();  ///< sum of ray ray^T / sigma^2 over them

  /// Adds one place, between two pixels.
  void add(const InverseDepthImage& image, int row, int column, int other_row, int other_column);
  Contact& operator+=(const Contact& other) {
    count += other.count;
    rays += other.rays;
    return *this;
  }
};

using RegionContacts = RegionPairs<Contact>;

/// Regions whose labels follow each other on a row or column across at most `bridge` unlabelled pixels, none of which
/// lies farther away than both by more than `residual` sigma: a groove separates surfaces even if they are coplanar.
RegionContacts findContacts(const InverseDepthImage& image, int bridge, double residual, const RegionMap& map);

/// Regions that face each other on a row or column across something nearer than the plane of the longer run by more
/// than `residual` sigma, which takes no more pixels than max_occluder times those of the two, with nothing farther
/// away between them. They may be one surface behind an occluder.
RegionContacts findOccludedContacts(const InverseDepthImage& image, double max_occluder, double residual,
                                    const RegionMap& map);

}  // namespace epcc
