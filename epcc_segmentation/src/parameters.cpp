// SPDX-License-Identifier: BSD-3-Clause
// Range checks of the parameters, in words.
#include "epcc_segmentation/parameters.h"

#include <sstream>

namespace epcc {

namespace {

/// "NAME must be in [LOW, HIGH] UNIT, not VALUE" unless it is; NaN never is.
template <typename Number>
std::string checkRange(const char* name, Number value, Number low, Number high, const char* unit = "") {
  if (value >= low && value <= high) return {};
  std::ostringstream text;
  text << name << " must be in [" << low << ", " << high << "]" << unit << ", not " << value;
  return text.str();
}

std::string firstOf(std::initializer_list<std::string> problems) {
  for (const auto& problem : problems)
    if (!problem.empty()) return problem;
  return {};
}

constexpr double kSmallest = 1e-6;

}  // namespace

std::string LineClusteringParameters::validate() const {
  return firstOf({checkRange("line.fit_samples (l)", fit_samples, 2, 100),
                  checkRange("line.validation_samples (l_v)", validation_samples, 1, 100),
                  checkRange("line.buffer_samples (n_buf)", buffer_samples, fit_samples + validation_samples, 1000),
                  checkRange("line.k_max", k_max, kSmallest, 100.0),
                  checkRange("line.projection_floor", projection_floor, 0.0, 1.0)});
}

std::string PlaneClusteringParameters::validate() const {
  return firstOf({checkRange("plane.k_max", k_max, kSmallest, 100.0),
                  checkRange("plane.max_gap (d_1)", max_gap, 0.0, 100.0, " m"),
                  checkRange("plane.look_back", look_back, 1, 100),
                  checkRange("plane.pair_look_back", pair_look_back, 1, look_back),
                  checkRange("plane.max_start_angle", max_start_angle, kSmallest, 90.0, " degrees"),
                  checkRange("plane.min_segments", min_segments, 1, 1000000),
                  checkRange("plane.min_points", min_points, 0, 1000000000)});
}

std::string LineGrowingParameters::validate() const {
  return firstOf({checkRange("line_growing.k_max", k_max, kSmallest, 100.0),
                  checkRange("line_growing.min_samples", min_samples, 3, 100),
                  checkRange("line_growing.max_gap_pixels", max_gap_pixels, 0, 1000)});
}

std::string PlaneGrowingParameters::validate() const {
  return firstOf({checkRange("plane_growing.k_max", k_max, kSmallest, 100.0),
                  checkRange("plane_growing.min_overlap_pixels", min_overlap_pixels, 1, 1000),
                  checkRange("plane_growing.max_prediction", max_prediction, 0.0, 1e6),
                  checkRange("plane_growing.min_points", min_points, 1, 1000000),
                  checkRange("plane_growing.min_segments", min_segments, 1, 1000000)});
}

std::string MergingParameters::validate() const {
  return firstOf({checkRange("merging.fragment_tolerance (c1)", fragment_tolerance, 0.0, 1e6),
                  checkRange("merging.offset_tolerance (c2)", offset_tolerance, 0.0, 100.0),
                  checkRange("merging.max_step", max_step, kSmallest, 1e6),
                  checkRange("merging.ragged_border", ragged_border, kSmallest, 1e6),
                  checkRange("merging.max_ragged_gain", max_ragged_gain, 1.0, 100.0),
                  checkRange("merging.max_ragged_step", max_ragged_step, 0.0, 1e6),
                  checkRange("merging.bridge_samples", bridge_samples, 0.0, 1000.0),
                  checkRange("merging.min_bridge_pixels", min_bridge_pixels, 0, 1000),
                  checkRange("merging.min_contacts", min_contacts, 1, 1000000),
                  checkRange("merging.min_samples", min_samples, 0.0, 1e6),
                  checkRange("merging.max_occluder", max_occluder, 0.0, 100.0)});
}

std::string RefinementParameters::validate() const {
  return firstOf({checkRange("refinement.passes", passes, 0, 1000),
                  checkRange("refinement.max_residual", max_residual, kSmallest, 100.0),
                  checkRange("refinement.flip_gain", flip_gain, 0.0, 100.0),
                  checkRange("refinement.crease_passes", crease_passes, 0, 1000),
                  checkRange("refinement.crease_vote_pixels", crease_vote_pixels, 1, 100),
                  checkRange("refinement.crease_min_votes", crease_min_votes, 1, 1000000),
                  checkRange("refinement.crease_agreement", crease_agreement, 0.5, 1.0),
                  checkRange("refinement.crease_range", crease_range, 0.0, 100.0),
                  checkRange("refinement.crease_slack", crease_slack, 0.0, 100.0)});
}

std::string EvidenceParameters::validate() const {
  return firstOf({checkRange("evidence.min_points", min_points, 1, 1000000000),
                  checkRange("evidence.min_samples", min_samples, 0.0, 1e6),
                  checkRange("evidence.max_chi2", max_chi2, kSmallest, 1e6),
                  checkRange("evidence.min_evidence", min_evidence, 0.0, 1e6),
                  checkRange("evidence.rough_evidence", rough_evidence, 0.0, 1e6),
                  checkRange("evidence.min_radius", min_radius, 0.0, 1e6),
                  checkRange("evidence.bending_share", bending_share, 0.0, 1.0),
                  checkRange("evidence.bending_evidence", bending_evidence, 0.0, 1e6)});
}

std::string Parameters::validate() const {
  if (mode == Mode::Paper && scan == ScanDirection::Both) return "scan: the paper mode scans columns or rows, not both";
  return firstOf({line.validate(), plane.validate(), line_growing.validate(), plane_growing.validate(),
                  merging.validate(), refinement.validate(), evidence.validate(),
                  checkRange("threads", threads, 1, 256)});
}

}  // namespace epcc
