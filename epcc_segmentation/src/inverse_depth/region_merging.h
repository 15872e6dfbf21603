// SPDX-License-Identifier: BSD-3-Clause
// S4: neighbouring regions that are one surface within the sensor's error become one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/merge_queue.h"
#include "inverse_depth/plane_batch.h"
#include "inverse_depth/region_contacts.h"
#include "inverse_depth/region_sums.h"

namespace epcc {

/// Merges regions best-first. Keeps its memory from frame to frame.
class RegionMerger {
 public:
  /// Merges until no two regions in contact are alike, then unlabels the regions with fewer than min_samples
  /// independent samples. Labels and moments of `map` are updated; the contacts are used up.
  void merge(RegionContacts& contacts, const InverseDepthParameters& parameters, const SensorModel& sensor,
             RegionMap& map, int threads = 1);
  /// Of the last merge: pairs of known regions in contact that are one surface by its rule, and those that are two.
  const std::vector<RegionPair>& alikeKnown() const { return alike_known_; }
  const std::vector<RegionPair>& apartKnown() const { return apart_known_; }

 private:
  /// A region, or what became of some. Which of two nodes takes the other in is a question of their contacts, not of
  /// their labels: those of the node with fewer move, so that a region with thousands of neighbours is not walked
  /// through at every merge.
  struct Node {
    std::int32_t label = 0;  ///< the smallest of the regions
    int contacts = 0;        ///< at most so many
    int first = -1;          ///< end of a contact
    double judged_n = 0.0;   ///< pixels when all its contacts were judged
    RegionSums sums;
    SumsPlane plane;
  };
  /// The last one of a contact.
  struct Judgement {
    std::int32_t a = 0, b = 0;  ///< the labels of its regions, a < b
    int version_a = 0, version_b = 0;
  };
  /// A contact that no step rules out, and the mean square of its step, in sigma along the ray.
  struct JudgedStep {
    int contact;
    double squares;
  };

  void begin(const RegionMap& map);
  void fitNodes(const RegionMap& map);
  void linkContacts();
  void link(int end, int node);
  void judgeListed();
  bool judgeStep(int number);
  bool areKnown(const Node& a, const Node& b) const { return a.label <= known_ && b.label <= known_; }
  bool judgePlane(const JudgedStep& step, double slope_factor, double rss);
  void listContacts(Node& node);
  bool isFresh(const Judgement& judgement);
  void mergeLabels(std::int32_t a, std::int32_t b);
  void moveContacts(int from, int into, bool judge_moved);
  double tolerance(const Node& a, const Node& b, int places, double step2) const;
  void judgeKnown();
  void dropSmallRegions(std::vector<PlaneMoments>& regions);

  Contact& contact(int number) { return contacts_->contacts[static_cast<std::size_t>(number)]; }
  Node& node(int k) { return nodes_[static_cast<std::size_t>(k)]; }
  int& nodeAt(int end) { return node_at_[static_cast<std::size_t>(end)]; }
  int& nextOf(int end) { return next_[static_cast<std::size_t>(end)]; }
  int& nodeOf(std::int32_t label) { return node_of_[static_cast<std::size_t>(label)]; }
  int& version(std::int32_t label) { return version_[static_cast<std::size_t>(label)]; }

  InverseDepthParameters::Merging parameters_;
  double region_tolerance_ = 0.0;
  double pixels_per_sample_ = 1.0;
  std::int32_t known_ = 0;  ///< the first so many labels do not join each other
  std::vector<RegionPair> alike_known_, apart_known_;
  RegionContacts* contacts_ = nullptr;  ///< numbered; one that went up in another has no places left
  std::vector<Node> nodes_;             ///< first one per label; 0 is none
  std::vector<int> node_of_, version_;  ///< per label
  std::vector<int> node_at_, next_;     ///< per end of a contact, 2 number and 2 number + 1: its node; the node's next
  MergeQueue queue_;
  std::vector<Judgement> judgements_;     ///< per contact
  std::vector<int> to_judge_;             ///< contacts
  PlaneBatch batch_;                      ///< of pairs of regions as one
  JudgedStep judged_[PlaneBatch::kSize];  ///< the same
  std::vector<std::int32_t> new_label_;   ///< per label
};

}  // namespace epcc
