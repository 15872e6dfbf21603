// SPDX-License-Identifier: BSD-3-Clause
// S4: best-first queue over pairs of regions. A contact whose cost is out of date when its turn comes is judged once
// more.
#include "inverse_depth/region_merging.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "pi.h"

namespace epcc {

namespace {

constexpr double kMaxSlopeFactor = 26.0;  // slopeFactor() is clipped
constexpr double kGrowth = 1.1;           // of a region's pixels, until all its contacts are judged again
constexpr double kLeastTolerance = 0.5;   // of the one for correlated error: no calibration is perfect
constexpr double kBendingReach = 20.0;  // grid pixels, 320 to the longer side: how far the bending of depth is the same

/// What the slow bending of a sensor adds to the squared offset of two regions, in squared region tolerances. It is the
/// same on both sides of a border and differs farther apart, so that deep regions lie off each other by more than
/// narrow ones; and where the error of one pixel tells nothing of the next there is none.
double bendingOf(double depth_of_region, double pixels_per_sample) {
  const double reach = depth_of_region / kBendingReach;
  const double memory = 1.0 - std::min(1.0, 2.0 * kPi / pixels_per_sample);
  return memory * (1.0 - std::exp(-0.5 * reach * reach));
}

}  // namespace

void RegionMerger::merge(RegionContacts& contacts, const InverseDepthParameters& parameters, const SensorModel& sensor,
                         RegionMap& map, int threads) {
  parameters_ = parameters.expert.merging;
  region_tolerance_ = parameters.region_tolerance * std::max(kLeastTolerance, std::sqrt(sensor.correlatedShare()));
  pixels_per_sample_ = sensor.pixelsPerSample();
  known_ = map.known;
  alike_known_.clear();
  contacts_ = &contacts;
  begin(map);
  linkContacts();
  to_judge_.resize(contacts.contacts.size());
  std::iota(to_judge_.begin(), to_judge_.end(), 0);
  judgeListed();
  while (!queue_.empty()) {
    const int next = queue_.pop();
    const Judgement& judgement = judgements_[static_cast<std::size_t>(next)];
    if (!isFresh(judgement)) {
      to_judge_.assign(1, next);
      judgeListed();
      continue;
    }
    const std::int32_t a = judgement.a, b = judgement.b;
    PlaneMoments& moved = map.regions[static_cast<std::size_t>(b) - 1];
    map.regions[static_cast<std::size_t>(a) - 1] += moved;
    moved = PlaneMoments();
    mergeLabels(a, b);
  }
  judgeKnown();
  dropSmallRegions(map.regions);
  map.relabel(new_label_, threads);
}

void RegionMerger::begin(const RegionMap& map) {
  const std::size_t labels = map.regions.size() + 1;
  nodes_.assign(labels, Node());
  node_of_.resize(labels);
  new_label_.resize(labels);
  version_.assign(labels, 0);
  for (std::size_t k = 0; k < labels; ++k) {
    node_of_[k] = static_cast<int>(k);
    new_label_[k] = nodes_[k].label = static_cast<std::int32_t>(k);
  }
  fitNodes(map);
}

void RegionMerger::fitNodes(const RegionMap& map) {
  int fitted[PlaneBatch::kSize];
  for (std::size_t next = 0; next < map.regions.size();) {
    batch_.count = 0;
    for (; next < map.regions.size() && batch_.count < PlaneBatch::kSize; ++next) {
      if (map.regions[next].n <= 0.0) continue;
      Node& region = nodes_[next + 1];
      region.sums = RegionSums(map.regions[next]);
      region.judged_n = region.sums.n;
      fitted[batch_.count] = static_cast<int>(next) + 1;
      batch_.add(region.sums);
    }
    fitPlanes(batch_);
    for (int k = 0; k < batch_.count; ++k) node(fitted[k]).plane = batch_.plane(k);
  }
}

void RegionMerger::linkContacts() {
  const std::vector<RegionPair>& pairs = contacts_->table.pairs();
  node_at_.resize(2 * pairs.size());
  next_.resize(2 * pairs.size());
  judgements_.assign(pairs.size(), Judgement());
  queue_.clear(pairs.size());
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

// Sixteen at a time, those that a step keeps apart not among them.
void RegionMerger::judgeListed() {
  for (std::size_t next = 0; next < to_judge_.size();) {
    batch_.count = 0;
    for (; next < to_judge_.size() && batch_.count < PlaneBatch::kSize; ++next)
      if (!judgeStep(to_judge_[next])) queue_.remove(to_judge_[next]);
    fitPlanes(batch_);
    for (int k = 0; k < batch_.count; ++k)
      if (!judgePlane(judged_[k], batch_.slope_factor[k], batch_.rss[k])) queue_.remove(judged_[k].contact);
  }
}

// A step along the common border keeps two surfaces apart, however small one of them is; many are higher than any slope
// allows.
bool RegionMerger::judgeStep(int number) {
  const Contact& places = contact(number);
  if (places.count < parameters_.min_contacts) return false;
  const Node& a = node(nodeAt(2 * number));
  const Node& b = node(nodeAt(2 * number + 1));
  const Eigen::Vector3d difference(a.plane.x - b.plane.x, a.plane.y - b.plane.y, a.plane.z - b.plane.z);
  const double squares = places.squares(difference) / places.count;
  if (squares > parameters_.max_step * parameters_.max_step * kMaxSlopeFactor) return false;
  judged_[batch_.count] = {number, squares};
  batch_.add(a.sums + b.sums);
  return true;
}

// A contact whose regions may merge joins the queue.
bool RegionMerger::judgePlane(const JudgedStep& step, double slope_factor, double rss) {
  const double step2 = step.squares / slope_factor;
  if (step2 > parameters_.max_step * parameters_.max_step) return false;
  const Node& a = node(nodeAt(2 * step.contact));
  const Node& b = node(nodeAt(2 * step.contact + 1));
  const double allowed = tolerance(a, b, contact(step.contact).count, step2) * slope_factor;
  const double cost = (rss - a.plane.rss - b.plane.rss) / allowed;
  if (!(cost <= 1.0)) return false;
  if (areKnown(a, b)) {
    alike_known_.emplace_back(a.label, b.label);
    return false;
  }
  Judgement& judgement = judgements_[static_cast<std::size_t>(step.contact)];
  judgement.a = std::min(a.label, b.label);
  judgement.b = std::max(a.label, b.label);
  judgement.version_a = version(judgement.a);
  judgement.version_b = version(judgement.b);
  queue_.set(step.contact, cost);
  return true;
}

/// The increase of RSS that offset and correlation allow.
double RegionMerger::tolerance(const Node& a, const Node& b, int places, double step2) const {
  // Two planes that compete for the same pixels all along (a ragged border) differ by the error, not by the scene;
  // unless there is a step, which the error frays too.
  const double smaller = std::min(a.sums.n, b.sums.n);
  double offset = region_tolerance_ * std::sqrt(1.0 + bendingOf(smaller / places, pixels_per_sample_));
  if (step2 < parameters_.max_ragged_step * parameters_.max_ragged_step) {
    const double raggedness = places / (4.0 * std::sqrt(smaller));
    offset *= std::clamp(raggedness / parameters_.ragged_border, 1.0, parameters_.max_ragged_gain);
  }
  return parameters_.fragment_tolerance * pixels_per_sample_ + offset * offset * smaller;
}

/// The contacts of a node are to be judged; those that went up in others leave its list.
void RegionMerger::listContacts(Node& node) {
  to_judge_.clear();
  for (int* end = &node.first; *end >= 0;) {
    if (contact(*end / 2).count > 0) {
      to_judge_.push_back(*end / 2);
      end = &nextOf(*end);
    } else {
      *end = nextOf(*end);
      --node.contacts;
    }
  }
}

/// The regions are as they were when the cost was found.
bool RegionMerger::isFresh(const Judgement& judgement) {
  return judgement.version_a == version(judgement.a) && judgement.version_b == version(judgement.b);
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
    listContacts(merged);
  }
  judgeListed();
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
      queue_.remove(number);
      continue;
    }
    const RegionPair pair(into, neighbour);
    const int known = contacts_->table.numberOf(pair);
    if (known >= 0) {
      contact(known) += contact(number);
      contact(number).count = 0;
      queue_.remove(number);
      to_judge_.push_back(known);
    } else {
      link(end, into);
      contacts_->table.assign(pair, number);
      if (judge_moved) to_judge_.push_back(number);
    }
  }
}

// As they are after the merge: what joined them is theirs.
void RegionMerger::judgeKnown() {
  alike_known_.clear();
  apart_known_.clear();
  if (known_ == 0) return;
  to_judge_.clear();
  for (int number = 0; number < static_cast<int>(judgements_.size()); ++number)
    if (contact(number).count >= parameters_.min_contacts &&
        areKnown(node(nodeAt(2 * number)), node(nodeAt(2 * number + 1))))
      to_judge_.push_back(number);
  judgeListed();
  for (const int number : to_judge_) {
    const RegionPair pair(node(nodeAt(2 * number)).label, node(nodeAt(2 * number + 1)).label);
    const bool is_alike = std::any_of(alike_known_.begin(), alike_known_.end(), [&pair](const RegionPair& other) {
      return other.low == pair.low && other.high == pair.high;
    });
    if (!is_alike) apart_known_.push_back(pair);
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
    const bool is_known = k <= static_cast<std::size_t>(known_);
    if (!is_known && region.n > 0.0 && region.n < fewest_pixels) {
      region = PlaneMoments();
      label = 0;
    }
  }
}

}  // namespace epcc
