// SPDX-License-Identifier: BSD-3-Clause
// The methods of the comparison by name, and their parameter sets.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "baselines/organized_multi_plane_segmenter.h"
#include "baselines/plane_segmenter.h"
#include "baselines/ransac_segmenter.h"
#include "baselines/region_growing_segmenter.h"
#include "epcc_segmentation/parameters.h"

namespace epcc {

/// The parameters of every method.
struct SegmenterOptions {
  Parameters epcc;        ///< of "epcc", in Mode::InverseDepth
  Parameters epcc_paper;  ///< of "epcc-paper", in Mode::Paper
  RegionGrowingParameters region_growing;
  RansacParameters ransac;
  OrganizedMultiPlaneParameters organized_multi_plane;
};

/// For real frames of any depth camera and distance: EPCC with its own defaults, all scan directions that the mode has;
/// for the baselines see defaultParameters() in registry.cpp, value by value.
SegmenterOptions defaultParameters();

/// Table 3 of the paper for the scene 'a', 'b', 'c' or 'd'; nothing for another letter. The paper has no parameters
/// for "epcc" and "omps": they keep those of defaultParameters().
std::optional<SegmenterOptions> paperParameters(char scene);

/// epcc, epcc-paper, region-growing, ransac, omps.
std::vector<std::string> segmenterNames();

/// Whether a method's result depends on RansacParameters::seed.
bool drawsAtRandom(const std::string& name);

/// A fresh method, or null for a name that segmenterNames() does not hold. Parameters out of range do not show here
/// but in segment(). Imported labels need a folder and have their own class, ImportedLabelsSegmenter.
std::unique_ptr<PlaneSegmenter> makeSegmenter(const std::string& name,
                                              const SegmenterOptions& options = defaultParameters());

}  // namespace epcc
