// SPDX-License-Identifier: BSD-3-Clause
// A cluster and a surface match if they share at least half of their union, each with one partner at most.
#include "eval/measures/instance_measures.h"

#include <cmath>
#include <limits>

namespace epcc {

namespace {

constexpr double kMillion = 1e6;

double ratio(double part, long whole) {
  return whole > 0 ? part / static_cast<double>(whole) : std::numeric_limits<double>::quiet_NaN();
}

InstanceMatch compare(const OverlapTable& table, std::size_t c, std::size_t g) {
  const auto overlap = static_cast<double>(table.overlap(c, g));
  const auto sizes = static_cast<double>(table.clusterSize(c) + table.surfaceSize(g));
  return {g, c, overlap / (sizes - overlap), 2.0 * overlap / sizes};
}

/// IoU >= 0.5 in whole numbers.
bool matches(const OverlapTable& table, std::size_t c, std::size_t g) {
  return 3 * table.overlap(c, g) >= table.clusterSize(c) + table.surfaceSize(g);
}

}  // namespace

std::vector<InstanceMatch> matchInstances(const OverlapTable& table) {
  // Above 0.5 a partner has no rival. At exactly 0.5 two halves of one region may claim it; the first gets it, and
  // the other fits nothing else.
  std::vector<InstanceMatch> found;
  std::vector<bool> taken(table.clusterCount() + 1, false);
  for (std::size_t g = 1; g <= table.surfaceCount(); ++g)
    for (std::size_t c = 1; c <= table.clusterCount(); ++c) {
      if (taken[c] || !matches(table, c, g)) continue;
      taken[c] = true;
      found.push_back(compare(table, c, g));
      break;
    }
  return found;
}

double InstanceMeasures::precision() const {
  return ratio(static_cast<double>(matched), clusters);
}

double InstanceMeasures::recall() const {
  return ratio(static_cast<double>(matched), surfaces);
}

double InstanceMeasures::meanIou() const {
  return ratio(static_cast<double>(iou_millionths) / kMillion, matched);
}

double InstanceMeasures::meanDice() const {
  return ratio(static_cast<double>(dice_millionths) / kMillion, matched);
}

double InstanceMeasures::coverage() const {
  return ratio(static_cast<double>(dominated_pixels), plane_pixels);
}

InstanceMeasures& InstanceMeasures::operator+=(const InstanceMeasures& other) {
  surfaces += other.surfaces;
  clusters += other.clusters;
  matched += other.matched;
  iou_millionths += other.iou_millionths;
  dice_millionths += other.dice_millionths;
  plane_pixels += other.plane_pixels;
  dominated_pixels += other.dominated_pixels;
  return *this;
}

InstanceMeasures instanceMeasures(const OverlapTable& table) {
  InstanceMeasures measures;
  measures.surfaces = static_cast<long>(table.surfaceCount());
  measures.clusters = static_cast<long>(table.clusterCount());
  for (const InstanceMatch& match : matchInstances(table)) {
    ++measures.matched;
    measures.iou_millionths += std::lround(kMillion * match.iou);
    measures.dice_millionths += std::lround(kMillion * match.dice);
  }
  for (std::size_t g = 1; g <= table.surfaceCount(); ++g) measures.plane_pixels += table.surfaceSize(g);
  for (std::size_t c = 1; c <= table.clusterCount(); ++c) {
    const std::size_t g = table.dominant(c);
    if (g > 0) measures.dominated_pixels += table.overlap(c, g);
  }
  return measures;
}

}  // namespace epcc
