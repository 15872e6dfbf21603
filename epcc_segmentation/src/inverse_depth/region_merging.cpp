// SPDX-License-Identifier: BSD-3-Clause
// S4: best-first queue over pairs of regions. An entry that is out of date when its turn comes is judged once more.
#include "inverse_depth/region_merging.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace epcc {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kMaxSlopeFactor = 26.0;  // slopeFactor() is clipped
constexpr double kGrowth = 1.1;           // of a region's pixels, until all its contacts are judged again

}  // namespace

void RegionMerger::merge(RegionContacts& contacts, const InverseDepthParameters& parameters, const SensorModel& sensor,
                         RegionMap& map) {
  parameters_ = parameters.expert.merging;
  region_tolerance_ = parameters.region_tolerance;
  pixels_per_sample_ = sensor.pixelsPerSample();
  contacts_ = &contacts;
  begin(map);
  linkContacts();
  for (std::size_t k = 0; k < contacts.contacts.size(); ++k) judge(static_cast<int>(k));
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<Candidate>());
    const Candidate next = queue_.back();
    queue_.pop_back();
    if (!isLast(next)) continue;
    if (!isFresh(next)) {
      judge(next.contact);
      continue;
    }
    PlaneMoments& moved = map.regions[static_cast<std::size_t>(next.b) - 1];
    map.regions[static_cast<std::size_t>(next.a) - 1] += moved;
    moved = PlaneMoments();
    mergeLabels(next.a, next.b);
  }
  dropSmallRegions(map.regions);
  map.relabel(new_label_);
}

void RegionMerger::begin(const RegionMap& map) {
  const std::size_t labels = map.regions.size() + 1;
  nodes_.assign(labels, Node());
  node_of_.resize(labels);
  new_label_.resize(labels);
  version_.assign(labels, 0);
  queue_.clear();
  for (std::size_t k = 0; k < labels; ++k) {
    node_of_[k] = static_cast<int>(k);
    new_label_[k] = nodes_[k].label = static_cast<std::int32_t>(k);
    if (k == 0) continue;
    nodes_[k].sums = RegionSums(map.regions[k - 1]);
    nodes_[k].plane = SumsPlane(nodes_[k].sums);
    nodes_[k].judged_n = nodes_[k].sums.n;
  }
}

void RegionMerger::linkContacts() {
  const std::vector<RegionPair>& pairs = contacts_->table.pairs();
  node_at_.resize(2 * pairs.size());
  next_.resize(2 * pairs.size());
  judgements_.assign(pairs.size(), Judgement());
  int end = 0;
  for (const RegionPair& pair : pairs) {
    link(end++, pair.low);
    link(end++, pair.high);
  }
}

void RegionMerger::link(int end, int k) {
  nodeAt(end) = k;
  nextOf(end) = node(k).first;
  node(k).first = end;
  ++node(k).contacts;
}

void RegionMerger::judge(int number) {
  Judgement& judgement = judgements_[static_cast<std::size_t>(number)];
  ++judgement.number;
  if (contact(number).count < parameters_.min_contacts) return;
  const Node& a = node(nodeAt(2 * number));
  const Node& b = node(nodeAt(2 * number + 1));
  const double merge_cost = cost(a, b, contact(number));
  if (!(merge_cost <= 1.0)) return;
  const std::int32_t low = std::min(a.label, b.label), high = std::max(a.label, b.label);
  judgement.version_a = version(low);
  judgement.version_b = version(high);
  queue_.push_back({merge_cost, low, high, number, judgement.number});
  std::push_heap(queue_.begin(), queue_.end(), std::greater<Candidate>());
}

void RegionMerger::judgeAll(Node& node) {
  for (int* end = &node.first; *end >= 0;) {
    if (contact(*end / 2).count > 0) {
      judge(*end / 2);
      end = &nextOf(*end);
    } else {
      *end = nextOf(*end);
      --node.contacts;
    }
  }
}

/// Cost of a merge, <= 1 to merge: RSS increase over what offset and correlation allow.
double RegionMerger::cost(const Node& a, const Node& b, const Contact& contact) const {
  // A step along the common border keeps two surfaces apart, however small one of them is; many are higher than any
  // slope allows.
  const Eigen::Vector3d difference(a.plane.x - b.plane.x, a.plane.y - b.plane.y, a.plane.z - b.plane.z);
  const double squares = contact.squares(difference) / contact.count;
  const double max_squares = parameters_.max_step * parameters_.max_step;
  if (squares > max_squares * kMaxSlopeFactor) return kNever;
  const SumsPlane plane(a.sums + b.sums);
  const double step2 = squares / plane.slope_factor;
  if (step2 > max_squares) return kNever;

  // Two planes that compete for the same pixels all along (a ragged border) differ by the error, not by the scene;
  // unless there is a step, which the error frays too.
  const double smaller = std::min(a.sums.n, b.sums.n);
  double offset = region_tolerance_;
  if (step2 < parameters_.max_ragged_step * parameters_.max_ragged_step) {
    const double raggedness = contact.count / (4.0 * std::sqrt(smaller));
    offset *= std::clamp(raggedness / parameters_.ragged_border, 1.0, parameters_.max_ragged_gain);
  }
  const double tolerance = parameters_.fragment_tolerance * pixels_per_sample_ + offset * offset * smaller;
  return (plane.rss - a.plane.rss - b.plane.rss) / (tolerance * plane.slope_factor);
}

bool RegionMerger::isLast(const Candidate& candidate) const {
  return candidate.judgement == judgements_[static_cast<std::size_t>(candidate.contact)].number;
}

/// The regions are as they were when the cost was found.
bool RegionMerger::isFresh(const Candidate& candidate) {
  const Judgement& judgement = judgements_[static_cast<std::size_t>(candidate.contact)];
  return judgement.version_a == version(candidate.a) && judgement.version_b == version(candidate.b);
}

// b becomes part of a. The plane of a large region hardly moves when a fragment joins it: of its contacts only those
// that changed are judged again, the others when their turn comes or when the region has grown.
void RegionMerger::mergeLabels(std::int32_t a, std::int32_t b) {
  int into = nodeOf(a), from = nodeOf(b);
  if (node(into).contacts < node(from).contacts) std::swap(into, from);
  Node& merged = node(into);
  merged.label = a;
  merged.sums = merged.sums + node(from).sums;
  merged.plane = SumsPlane(merged.sums);
  nodeOf(a) = into;
  new_label_[static_cast<std::size_t>(b)] = a;
  ++version(a);
  ++version(b);
  const auto hasGrown = [&merged](const Node& part) { return merged.sums.n > kGrowth * part.judged_n; };
  to_judge_.clear();
  moveContacts(from, into, hasGrown(node(from)));
  if (hasGrown(merged)) {
    merged.judged_n = merged.sums.n;
    judgeAll(merged);
  } else {
    for (const int number : to_judge_) judge(number);
  }
}

// The contacts that changed, and if so asked those that moved, are to be judged.
void RegionMerger::moveContacts(int from, int into, bool judge_moved) {
  for (int end = node(from).first, next = -1; end >= 0; end = next) {
    next = nextOf(end);
    const int number = end / 2;
    const int neighbour = nodeAt(end ^ 1);
    if (contact(number).count == 0) continue;
    if (neighbour == into) {
      contact(number).count = 0;
      continue;
    }
    const RegionPair pair(into, neighbour);
    const int known = contacts_->table.numberOf(pair);
    if (known >= 0) {
      contact(known) += contact(number);
      contact(number).count = 0;
      to_judge_.push_back(known);
    } else {
      link(end, into);
      contacts_->table.assign(pair, number);
      if (judge_moved) to_judge_.push_back(number);
    }
  }
}

/// Empties the small regions and finds the final labels. Of regions that were empty there are no pixels to relabel.
void RegionMerger::dropSmallRegions(std::vector<PlaneMoments>& regions) {
  const double fewest_pixels = parameters_.min_samples * pixels_per_sample_;
  for (std::size_t k = 1; k < new_label_.size(); ++k) {
    // A region was merged into one of a smaller label, which is final by now.
    std::int32_t& label = new_label_[k];
    label = label == static_cast<std::int32_t>(k) ? label : new_label_[static_cast<std::size_t>(label)];
    PlaneMoments& region = regions[k - 1];
    if (region.n > 0.0 && region.n < fewest_pixels) {
      region = PlaneMoments();
      label = 0;
    }
  }
}

}  // namespace epcc
