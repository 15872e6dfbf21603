// SPDX-License-Identifier: BSD-3-Clause
// S7: size, chi^2, the number of independent samples, and bending.
#include "inverse_depth/evidence.h"

#include <algorithm>
#include <cstddef>

namespace epcc {

bool isPlane(const PlaneMoments& region, const InverseDepthParameters& parameters, const SensorModel& sensor) {
  const InverseDepthParameters::Evidence& evidence = parameters.expert.evidence;
  const double pixels_per_sample = sensor.pixelsPerSample();
  if (region.n < std::max(static_cast<double>(parameters.min_points), evidence.min_samples * pixels_per_sample))
    return false;
  const RegionPlane plane(region);
  const double chi2 = plane.rss / (region.n * plane.slope_factor);
  if (!(chi2 <= evidence.max_chi2)) return false;  // nor is what has no plane
  double needed = evidence.min_evidence * std::max(0.5, chi2);
  if (chi2 > 1.0) needed = std::max(needed, evidence.rough_evidence);
  return region.n / pixels_per_sample >= needed;
}

namespace {

/// A quadric takes no more away than there is.
bool mayBeFacet(const PlaneMoments& region, const InverseDepthParameters::Evidence& evidence,
                double pixels_per_sample) {
  const RegionPlane plane(region);
  return plane.rss > evidence.bending_evidence * pixels_per_sample * plane.slope_factor;
}

bool isFacet(const Bending& bending, const InverseDepthParameters::Evidence& evidence, double pixels_per_sample) {
  return bending.curvature * evidence.min_radius > 1.0 && bending.gain > evidence.bending_share * bending.rss &&
         bending.gain > evidence.bending_evidence * pixels_per_sample;
}

}  // namespace

void rejectRegions(const InverseDepthImage& image, const InverseDepthParameters& parameters, const SensorModel& sensor,
                   RegionMap& map, EvidenceMemory& memory, int threads) {
  const InverseDepthParameters::Evidence& evidence = parameters.expert.evidence;
  const double pixels_per_sample = sensor.pixelsPerSample();
  const std::size_t count = map.regions.size();
  memory.is_plane.assign(count, 0);
  memory.may_bend.assign(count, 0);
  for (std::size_t k = 0; k < count; ++k) {
    const PlaneMoments& region = map.regions[k];
    if (!(region.n > 0.0)) continue;
    memory.is_plane[k] = isPlane(region, parameters, sensor) ? 1 : 0;
    if (memory.is_plane[k] == 0) continue;
    memory.may_bend[k] = mayBeFacet(region, evidence, pixels_per_sample) ? 1 : 0;
  }
  measureBending(image, map, memory.may_bend, memory.bending, threads);

  memory.new_label.assign(count + 1, 0);
  map.doubtful.assign(static_cast<std::size_t>(map.known), 0);
  for (std::size_t k = 0; k < count; ++k) {
    const bool is_plane = memory.is_plane[k] != 0 && !isFacet(memory.bending.bending[k], evidence, pixels_per_sample);
    const bool is_known = static_cast<int>(k) < map.known;
    if (is_known) map.doubtful[k] = is_plane ? 0 : 1;
    if (is_plane || is_known)
      memory.new_label[k + 1] = static_cast<std::int32_t>(k + 1);
    else
      map.regions[k] = PlaneMoments();
  }
  map.relabel(memory.new_label, threads);
}

}  // namespace epcc
