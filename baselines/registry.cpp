// SPDX-License-Identifier: BSD-3-Clause
// Names, Table 3, and the parameters for real frames.
#include "baselines/registry.h"

#include "baselines/epcc_segmenter.h"

namespace epcc {

namespace {
// Lengths of the PCL baselines on real frames, in distances between neighbouring points: fixed lengths that suit a room
// lose a table top with parts of a few millimetres. Of 3 and 5 the leaf that finds more surfaces on the real frames.
constexpr double kGrowingLeaf = 3.0;
constexpr double kRansacLeaf = 5.0;
constexpr double kRansacInlier = 8.0;  // 2.6 cm at 2 m in front of a 640x480 camera
}  // namespace

SegmenterOptions defaultParameters() {
  SegmenterOptions options;
  options.epcc.mode = Mode::Default;
  options.epcc.scan = ScanDirection::Both;
  options.epcc_paper.mode = Mode::Paper;
  options.epcc_paper.scan = ScanDirection::Columns;
  options.region_growing.leaf = {0.0, kGrowingLeaf};
  options.ransac.leaf = {0.0, kRansacLeaf};
  options.ransac.inlier_distance = {0.0, kRansacInlier};
  return options;
}

std::optional<SegmenterOptions> paperParameters(char scene) {
  // Scenes b and c share values where the print spans both (docs/evaluation.md).
  struct Table3 {
    double leaf, curvature, smoothness_degrees, ransac_distance, normal_weight, plane_k_max;
  };
  constexpr Table3 kScenes[] = {{0.01, 0.3, 3.0, 0.015, 0.02, 3.0},
                                {0.03, 0.5, 4.0, 0.032, 0.02, 3.0},
                                {0.03, 0.5, 4.0, 0.050, 0.03, 2.0},
                                {0.04, 0.3, 3.0, 0.050, 0.03, 2.0}};
  if (scene < 'a' || scene > 'd') return std::nullopt;
  const Table3& row = kScenes[scene - 'a'];

  SegmenterOptions options = defaultParameters();
  options.region_growing = RegionGrowingParameters();
  options.region_growing.leaf = {row.leaf, 0.0};
  options.region_growing.curvature_threshold = row.curvature;
  options.region_growing.smoothness_degrees = row.smoothness_degrees;
  options.ransac = RansacParameters();
  options.ransac.leaf = {row.leaf, 0.0};
  options.ransac.inlier_distance = {row.ransac_distance, 0.0};
  options.ransac.normal_distance_weight = row.normal_weight;
  options.epcc_paper.line.k_max = 2.0;
  options.epcc_paper.line.fit_samples = 3;
  options.epcc_paper.line.validation_samples = 5;  // k_min = 8
  options.epcc_paper.plane.k_max = row.plane_k_max;
  options.epcc_paper.plane.max_gap = 0.15;
  options.epcc_paper.plane.min_segments = 15;  // 30 endpoints
  return options;
}

std::vector<std::string> segmenterNames() {
  return {"epcc", "epcc-paper", "region-growing", "ransac", "omps"};
}

std::unique_ptr<PlaneSegmenter> makeSegmenter(const std::string& name, const SegmenterOptions& options) {
  if (name == "epcc") return std::make_unique<EpccSegmenter>(options.epcc);
  if (name == "epcc-paper") return std::make_unique<EpccSegmenter>(options.epcc_paper);
  if (name == "region-growing") return std::make_unique<RegionGrowingSegmenter>(options.region_growing);
  if (name == "ransac") return std::make_unique<RansacSegmenter>(options.ransac);
  if (name == "omps") return std::make_unique<OrganizedMultiPlaneSegmenter>(options.organized_multi_plane);
  return nullptr;
}

}  // namespace epcc
