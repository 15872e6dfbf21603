// SPDX-License-Identifier: BSD-3-Clause
// PCL's RANSAC with normals, plane after plane, the paper's second baseline.
#pragma once

#include "baselines/adaptive_length.h"
#include "baselines/plane_segmenter.h"

namespace epcc {

/// Parameters of RANSAC. The defaults here are those of scene (b) of Table 3; real frames use defaultParameters().
struct RansacParameters {
  AdaptiveLength leaf{0.03, 0.0};              ///< Edge of a voxel, that of region growing
  int normal_neighbours = 30;                  ///< Neighbours of a normal, as in region growing. [3, 10000]
  AdaptiveLength inlier_distance{0.032, 0.0};  ///< d_th
  double normal_distance_weight = 0.02;        ///< Share of the angle between the normals in the distance. [0, 1]
  int iterations = 100;                        ///< Most hypotheses a plane. [1, 1e6]
  int min_plane_points = 50;                   ///< Ends the search: fewest voxel points of a plane. [3, 1e9]
  int max_planes = 100;                        ///< Ends the search. [1, 1e6]
  int seed = 0;  ///< Order in which the points are numbered, and with it the draws; 0: as they come. [0, 1e6]
  std::string validate() const;
};

/// pcl::VoxelGrid, pcl::NormalEstimation, then pcl::SACSegmentationFromNormals with SACMODEL_NORMAL_PLANE and
/// SAC_RANSAC again and again on the points that are left; each pixel takes the label of its voxel.
///
/// The paper says neither on which cloud RANSAC ran nor when it stopped. Here it runs on region growing's cloud and
/// normals, whose even density keeps a near surface from hiding a far one, with PCL's optimised coefficients, and
/// stops when the best plane has fewer points than the smallest region of region growing (50), after max_planes,
/// or when PCL finds no model. A plane is everything near it: pieces of one plane in different places share a
/// label. PCL seeds its random numbers with a constant for each plane, so that the result repeats; another `seed`
/// gives another result, which repeats as well.
class RansacSegmenter : public PlaneSegmenter {
 public:
  explicit RansacSegmenter(const RansacParameters& parameters) : parameters_(parameters) {}
  std::string name() const override { return "ransac"; }

 protected:
  bool run(const SegmenterInput& input, PlaneSegmentation& result) override;

 private:
  RansacParameters parameters_;
};

}  // namespace epcc
