// SPDX-License-Identifier: BSD-3-Clause
// Counts overlaps and applies the rule for clusters on ignored ground.
#include "eval/measures/overlap_table.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace epcc {

namespace {

/// The ids that occur, 0 first whether it occurs or not, then ascending.
std::vector<std::int32_t> sortedIds(std::vector<std::int32_t> ids) {
  ids.push_back(0);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::size_t indexOf(const std::vector<std::int32_t>& ids, std::int32_t id) {
  return static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
}

/// Raw counts with ignored ground as a column of its own, the last one.
struct RawCounts {
  std::vector<std::int32_t> clusters, surfaces;
  std::size_t columns = 0;
  std::vector<long> counts;
  long& at(std::size_t c, std::size_t g) { return counts[c * columns + g]; }
};

RawCounts count(const std::vector<std::int32_t>& labels, const std::vector<std::int32_t>& truth,
                const std::vector<std::uint8_t>& depth_valid) {
  const auto valid = [&](std::size_t i) { return depth_valid.empty() || depth_valid[i] != 0; };
  std::vector<std::int32_t> cluster_ids, surface_ids;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0 || truth[i] < 0) throw std::invalid_argument("labels must not be negative");
    if (!valid(i)) continue;
    if (cluster_ids.empty() || cluster_ids.back() != labels[i]) cluster_ids.push_back(labels[i]);
    if (truth[i] != kIgnoreLabel && (surface_ids.empty() || surface_ids.back() != truth[i]))
      surface_ids.push_back(truth[i]);
  }
  RawCounts raw;
  raw.clusters = sortedIds(std::move(cluster_ids));
  raw.surfaces = sortedIds(std::move(surface_ids));
  raw.columns = raw.surfaces.size() + 1;
  raw.counts.assign(raw.clusters.size() * raw.columns, 0);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (valid(i))
      ++raw.at(indexOf(raw.clusters, labels[i]),
               truth[i] == kIgnoreLabel ? raw.columns - 1 : indexOf(raw.surfaces, truth[i]));
  return raw;
}

bool isScored(RawCounts& raw, std::size_t c, const std::vector<long>& surface_sizes) {
  long on_ground = 0;
  for (std::size_t g = 0; g + 1 < raw.columns; ++g) on_ground += raw.at(c, g);
  if (raw.at(c, raw.columns - 1) <= on_ground) return true;
  for (std::size_t g = 1; g + 1 < raw.columns; ++g)
    if (2 * raw.at(c, g) >= surface_sizes[g]) return true;
  return false;
}

}  // namespace

OverlapTable::OverlapTable(const std::vector<std::int32_t>& labels, const std::vector<std::int32_t>& truth,
                           const std::vector<std::uint8_t>& depth_valid) {
  if (labels.size() != truth.size() || (!depth_valid.empty() && depth_valid.size() != truth.size()))
    throw std::invalid_argument("labels, truth and depth must have the same number of pixels");
  RawCounts raw = count(labels, truth, depth_valid);
  surface_ids_ = raw.surfaces;
  surface_sizes_.assign(surface_ids_.size(), 0);
  for (std::size_t c = 0; c < raw.clusters.size(); ++c)
    for (std::size_t g = 0; g < surface_ids_.size(); ++g) surface_sizes_[g] += raw.at(c, g);

  cluster_ids_.push_back(0);
  std::vector<std::size_t> row_of(raw.clusters.size(), 0);
  for (std::size_t c = 1; c < raw.clusters.size(); ++c) {
    if (!isScored(raw, c, surface_sizes_)) continue;
    row_of[c] = cluster_ids_.size();
    cluster_ids_.push_back(raw.clusters[c]);
  }
  counts_.assign(cluster_ids_.size() * surface_ids_.size(), 0);
  cluster_sizes_.assign(cluster_ids_.size(), 0);
  for (std::size_t c = 0; c < raw.clusters.size(); ++c)
    for (std::size_t g = 0; g < surface_ids_.size(); ++g) {
      counts_[row_of[c] * surface_ids_.size() + g] += raw.at(c, g);
      cluster_sizes_[row_of[c]] += raw.at(c, g);
    }
}

std::size_t OverlapTable::dominant(std::size_t c) const {
  std::size_t best = 0;
  for (std::size_t g = 1; g < surface_ids_.size(); ++g)
    if (overlap(c, g) > overlap(c, best)) best = g;
  return best;
}

}  // namespace epcc
