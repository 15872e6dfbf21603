// SPDX-License-Identifier: BSD-3-Clause
// S7: size, chi^2 and the number of independent samples.
#include "inverse_depth/evidence.h"

#include <algorithm>

#include "inverse_depth/region_merging.h"

namespace epcc {

bool isPlane(const PlaneMoments& region, const EvidenceParameters& parameters, const SensorModel& sensor) {
  const double pixels_per_sample = sensor.pixelsPerSample();
  if (region.n < std::max(static_cast<double>(parameters.min_points), parameters.min_samples * pixels_per_sample))
    return false;
  const PlaneEstimate fit = region.fit(weakRidge(region));
  const double chi2 = fit.rss / (region.n * slopeFactor(fit.q, region.meanW()));
  if (chi2 > parameters.max_chi2) return false;
  return region.n / pixels_per_sample >= parameters.min_evidence * std::max(0.5, chi2);
}

void rejectRegions(const EvidenceParameters& parameters, const SensorModel& sensor, RegionMap& map) {
  std::vector<std::int32_t> new_label(map.regions.size() + 1, 0);
  for (std::size_t k = 0; k < map.regions.size(); ++k) {
    if (map.regions[k].n > 0.0 && isPlane(map.regions[k], parameters, sensor))
      new_label[k + 1] = static_cast<std::int32_t>(k + 1);
    else
      map.regions[k] = PlaneMoments();
  }
  map.relabel(new_label);
}

}  // namespace epcc
