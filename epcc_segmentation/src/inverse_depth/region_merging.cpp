// SPDX-License-Identifier: BSD-3-Clause
// S4: best-first queue over pairs of regions, stale entries skipped by version.
#include "inverse_depth/region_merging.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>

namespace epcc {

namespace {

using Neighbours = std::vector<std::map<std::int32_t, Contact>>;  // per region: neighbour -> contacts

Neighbours byRegion(const RegionContacts& pairs, std::size_t regions) {
  Neighbours neighbours(regions + 1);
  for (const auto& [pair, contact] : pairs) {
    neighbours[static_cast<std::size_t>(pair.low)][pair.high] = contact;
    neighbours[static_cast<std::size_t>(pair.high)][pair.low] = contact;
  }
  return neighbours;
}

/// A possible merge; of equal costs the smaller labels go first, so that the order is always the same.
struct Candidate {
  double cost;
  std::int32_t a, b;
  int version_a, version_b;
  bool operator>(const Candidate& other) const {
    if (cost != other.cost) return cost > other.cost;
    return a != other.a ? a > other.a : b > other.b;
  }
};

/// Cost of a merge, <= 1 to merge: RSS increase over what offset and correlation allow.
double mergeCost(const PlaneMoments& a, const PlaneMoments& b, const RegionPlane& plane_a, const RegionPlane& plane_b,
                 const Contact& contact, const InverseDepthParameters& parameters, double pixels_per_sample) {
  const InverseDepthParameters::Merging& merging = parameters.expert.merging;
  PlaneMoments merged = a;
  merged += b;
  const RegionPlane plane(merged);
  const double smaller = std::min(a.n, b.n);

  // A step along the common border keeps two surfaces apart, however small one of them is.
  const Eigen::Vector3d difference = plane_a.q - plane_b.q;
  const double step2 = difference.dot(contact.rays * difference) / (contact.count * plane.slope_factor);
  if (step2 > merging.max_step * merging.max_step) return std::numeric_limits<double>::infinity();

  // Two planes that compete for the same pixels all along (a ragged border) differ by the error, not by the scene;
  // unless there is a step, which the error frays too.
  double offset = parameters.region_tolerance;
  if (step2 < merging.max_ragged_step * merging.max_ragged_step) {
    const double raggedness = contact.count / (4.0 * std::sqrt(smaller));
    offset *= std::clamp(raggedness / merging.ragged_border, 1.0, merging.max_ragged_gain);
  }
  const double tolerance = merging.fragment_tolerance * pixels_per_sample + offset * offset * smaller;
  return (plane.rss - plane_a.rss - plane_b.rss) / (tolerance * plane.slope_factor);
}

class Merger {
 public:
  Merger(const InverseDepthParameters& parameters, double pixels_per_sample, RegionMap& map, Neighbours contacts)
      : parameters_(parameters),
        pixels_per_sample_(pixels_per_sample),
        map_(map),
        contacts_(std::move(contacts)),
        version_(map.regions.size() + 1, 0),
        parent_(map.regions.size() + 1) {
    for (std::size_t k = 0; k < parent_.size(); ++k) parent_[k] = static_cast<std::int32_t>(k);
    planes_.reserve(map.regions.size());
    for (const PlaneMoments& region : map.regions) planes_.emplace_back(region);
  }

  void run() {
    for (std::size_t a = 1; a < contacts_.size(); ++a)
      for (const auto& [b, contact] : contacts_[a])
        if (static_cast<std::int32_t>(a) < b) consider(static_cast<std::int32_t>(a), b, contact);
    while (!queue_.empty()) {
      const Candidate next = queue_.top();
      queue_.pop();
      if (next.version_a != version_[index(next.a)] || next.version_b != version_[index(next.b)]) continue;
      merge(next.a, next.b);
    }
  }

  /// Final label of each label.
  std::vector<std::int32_t> roots() {
    std::vector<std::int32_t> result(parent_.size());
    for (std::size_t k = 0; k < parent_.size(); ++k) {
      std::int32_t root = static_cast<std::int32_t>(k);
      while (parent_[index(root)] != root) root = parent_[index(root)];
      result[k] = root;
    }
    return result;
  }

 private:
  static std::size_t index(std::int32_t label) { return static_cast<std::size_t>(label); }
  PlaneMoments& region(std::int32_t label) { return map_.regions[index(label) - 1]; }
  RegionPlane& plane(std::int32_t label) { return planes_[index(label) - 1]; }

  void consider(std::int32_t a, std::int32_t b, const Contact& contact) {
    if (contact.count < parameters_.expert.merging.min_contacts) return;
    const double cost = mergeCost(region(a), region(b), plane(a), plane(b), contact, parameters_, pixels_per_sample_);
    if (cost > 1.0) return;
    if (a > b) std::swap(a, b);
    queue_.push({cost, a, b, version_[index(a)], version_[index(b)]});
  }

  // b becomes part of a.
  void merge(std::int32_t a, std::int32_t b) {
    region(a) += region(b);
    region(b) = PlaneMoments();
    plane(a) = RegionPlane(region(a));
    parent_[index(b)] = a;
    ++version_[index(a)];
    ++version_[index(b)];
    for (const auto& [neighbour, contact] : contacts_[index(b)]) {
      contacts_[index(neighbour)].erase(b);
      if (neighbour == a) continue;
      contacts_[index(a)][neighbour] += contact;
      contacts_[index(neighbour)][a] += contact;
    }
    contacts_[index(b)].clear();
    for (const auto& [neighbour, contact] : contacts_[index(a)]) consider(a, neighbour, contact);
  }

  const InverseDepthParameters& parameters_;
  double pixels_per_sample_;
  RegionMap& map_;
  std::vector<RegionPlane> planes_;  // of the regions, kept, for many pairs ask for them
  Neighbours contacts_;
  std::vector<int> version_;
  std::vector<std::int32_t> parent_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> queue_;
};

/// Empties the small regions and takes the label 0 for what ended in them.
void dropSmallRegions(double fewest_pixels, std::vector<PlaneMoments>& regions, std::vector<std::int32_t>& new_label) {
  for (auto& region : regions)
    if (region.n < fewest_pixels) region = PlaneMoments();
  for (auto& label : new_label)
    if (label != 0 && regions[static_cast<std::size_t>(label) - 1].n == 0.0) label = 0;
}

}  // namespace

void mergeRegions(const RegionContacts& contacts, const InverseDepthParameters& parameters, const SensorModel& sensor,
                  RegionMap& map) {
  Merger merger(parameters, sensor.pixelsPerSample(), map, byRegion(contacts, map.regions.size()));
  merger.run();
  std::vector<std::int32_t> new_label = merger.roots();
  dropSmallRegions(parameters.expert.merging.min_samples * sensor.pixelsPerSample(), map.regions, new_label);
  map.relabel(new_label);
}

}  // namespace epcc
