// SPDX-License-Identifier: BSD-3-Clause
// S7: size, chi^2, the number of independent samples, and bending.
#include "inverse_depth/evidence.h"

#include <algorithm>

#include "inverse_depth/surface_bending.h"

namespace epcc {

bool isPlane(const PlaneMoments& region, const InverseDepthParameters& parameters, const SensorModel& sensor) {
  const InverseDepthParameters::Evidence& evidence = parameters.expert.evidence;
  const double pixels_per_sample = sensor.pixelsPerSample();
  if (region.n < std::max(static_cast<double>(parameters.min_points), evidence.min_samples * pixels_per_sample))
    return false;
  const RegionPlane plane(region);
  const double chi2 = plane.rss / (region.n * plane.slope_factor);
  if (chi2 > evidence.max_chi2) return false;
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
                   RegionMap& map) {
  const std::size_t count = map.regions.size();
  std::vector<std::uint8_t> plane(count, 0), may_bend(count, 0);
  for (std::size_t k = 0; k < count; ++k) {
    plane[k] = map.regions[k].n > 0.0 && isPlane(map.regions[k], parameters, sensor);
    may_bend[k] = plane[k] != 0 && mayBeFacet(map.regions[k], parameters.expert.evidence, sensor.pixelsPerSample());
  }
  const std::vector<Bending> bending = measureBending(image, map, may_bend);

  std::vector<std::int32_t> new_label(count + 1, 0);
  for (std::size_t k = 0; k < count; ++k) {
    PlaneMoments& region = map.regions[k];
    if (plane[k] != 0 && !isFacet(bending[k], parameters.expert.evidence, sensor.pixelsPerSample()))
      new_label[k + 1] = static_cast<std::int32_t>(k + 1);
    else
      region = PlaneMoments();
  }
  map.relabel(new_label);
}

}  // namespace epcc
