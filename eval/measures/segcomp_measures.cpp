// SPDX-License-Identifier: BSD-3-Clause
// Candidate instances of the three classes, then the best ones that share no region.
#include "eval/measures/segcomp_measures.h"

#include <algorithm>

namespace epcc {

namespace {

enum class Class { Correct, Over, Under };

struct Instance {
  Class kind;
  std::vector<std::size_t> clusters;
  std::vector<std::size_t> surfaces;
  double mean_overlap;
};

double ratio(long part, long whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

// An edge case met exactly counts, although a tolerance such as 0.55 has no exact binary form.
bool holds(long part, long whole, double tolerance) {
  constexpr double kRounding = 1.0 - 1e-12;
  return part > 0 && static_cast<double>(part) >= kRounding * tolerance * static_cast<double>(whole);
}

/// A group of regions that lie, each by the tolerance, in one other region and together fill it: the shape of
/// both over- and under-segmentation. `overlap(i)` and `size(i)` belong to the group's candidates 1..count.
template <typename Overlap, typename Size>
bool findGroup(std::size_t count, long whole, double tolerance, const Overlap& overlap, const Size& size,
               std::vector<std::size_t>& group, double& mean_overlap) {
  long filled = 0;
  double ratios = 0.0;
  for (std::size_t i = 1; i <= count; ++i) {
    if (!holds(overlap(i), size(i), tolerance)) continue;
    group.push_back(i);
    filled += overlap(i);
    ratios += ratio(overlap(i), size(i));
  }
  if (group.size() < 2 || !holds(filled, whole, tolerance)) return false;
  mean_overlap = 0.5 * (ratios / static_cast<double>(group.size()) + ratio(filled, whole));
  return true;
}

std::vector<Instance> candidates(const OverlapTable& table, double tolerance) {
  std::vector<Instance> found;
  const std::size_t clusters = table.clusterCount();
  const std::size_t surfaces = table.surfaceCount();
  for (std::size_t g = 1; g <= surfaces; ++g)
    for (std::size_t c = 1; c <= clusters; ++c) {
      const long o = table.overlap(c, g);
      if (holds(o, table.clusterSize(c), tolerance) && holds(o, table.surfaceSize(g), tolerance))
        found.push_back(
            {Class::Correct, {c}, {g}, 0.5 * (ratio(o, table.clusterSize(c)) + ratio(o, table.surfaceSize(g)))});
    }
  for (std::size_t g = 1; g <= surfaces; ++g) {
    Instance over{Class::Over, {}, {g}, 0.0};
    if (findGroup(
            clusters, table.surfaceSize(g), tolerance, [&](std::size_t c) { return table.overlap(c, g); },
            [&](std::size_t c) { return table.clusterSize(c); }, over.clusters, over.mean_overlap))
      found.push_back(over);
  }
  for (std::size_t c = 1; c <= clusters; ++c) {
    Instance under{Class::Under, {c}, {}, 0.0};
    if (findGroup(
            surfaces, table.clusterSize(c), tolerance, [&](std::size_t g) { return table.overlap(c, g); },
            [&](std::size_t g) { return table.surfaceSize(g); }, under.surfaces, under.mean_overlap))
      found.push_back(under);
  }
  return found;
}

}  // namespace

SegcompMeasures& SegcompMeasures::operator+=(const SegcompMeasures& other) {
  correct += other.correct;
  over += other.over;
  under += other.under;
  missed += other.missed;
  noise += other.noise;
  return *this;
}

SegcompMeasures segcompMeasures(const OverlapTable& table, double tolerance) {
  std::vector<Instance> found = candidates(table, tolerance);
  std::stable_sort(found.begin(), found.end(),
                   [](const Instance& a, const Instance& b) { return a.mean_overlap > b.mean_overlap; });
  std::vector<bool> cluster_taken(table.clusterCount() + 1, false);
  std::vector<bool> surface_taken(table.surfaceCount() + 1, false);
  SegcompMeasures measures;
  for (const Instance& instance : found) {
    const auto taken = [](const std::vector<std::size_t>& ids, const std::vector<bool>& flags) {
      return std::any_of(ids.begin(), ids.end(), [&](std::size_t i) { return flags[i]; });
    };
    if (taken(instance.clusters, cluster_taken) || taken(instance.surfaces, surface_taken)) continue;
    for (const std::size_t c : instance.clusters) cluster_taken[c] = true;
    for (const std::size_t g : instance.surfaces) surface_taken[g] = true;
    (instance.kind == Class::Correct ? measures.correct
     : instance.kind == Class::Over  ? measures.over
                                     : measures.under)++;
  }
  measures.missed = std::count(surface_taken.begin() + 1, surface_taken.end(), false);
  measures.noise = std::count(cluster_taken.begin() + 1, cluster_taken.end(), false);
  return measures;
}

}  // namespace epcc
