// SPDX-License-Identifier: BSD-3-Clause
// PCL's region growing on a voxel-filtered cloud, the paper's first baseline.
#pragma once

#include "baselines/adaptive_length.h"
#include "baselines/plane_segmenter.h"

namespace epcc {

/// Parameters of region growing. The defaults here are those of scene (b) of Table 3; real frames use
/// defaultParameters().
struct RegionGrowingParameters {
  AdaptiveLength leaf{0.03, 0.0};    ///< l: edge of a voxel
  int normal_neighbours = 30;        ///< Neighbours of a normal. [3, 10000]
  int growing_neighbours = 50;       ///< k_n: neighbours that a region may grow to. [1, 10000]
  double smoothness_degrees = 4.0;   ///< Theta_th: largest angle between neighbouring normals. (0, 90]
  double curvature_threshold = 0.5;  ///< c_th: largest curvature of a seed. (0, 1]; PCL's never exceeds 1/3
  int min_cluster_size = 50;         ///< Fewest voxel points of a region. [1, 1e9]
  int max_cluster_size = 1000000;    ///< Most voxel points of a region. [min_cluster_size, 1e9]
  std::string validate() const;
};

/// pcl::VoxelGrid, pcl::NormalEstimation, pcl::RegionGrowing; each pixel takes the label of its voxel.
class RegionGrowingSegmenter : public PlaneSegmenter {
 public:
  explicit RegionGrowingSegmenter(const RegionGrowingParameters& parameters) : parameters_(parameters) {}
  std::string name() const override { return "region-growing"; }

 protected:
  bool run(const SegmenterInput& input, PlaneSegmentation& result) override;

 private:
  RegionGrowingParameters parameters_;
};

}  // namespace epcc
