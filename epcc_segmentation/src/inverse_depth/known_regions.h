// SPDX-License-Identifier: BSD-3-Clause
// Planes known from an earlier frame label the samples that they explain, before anything is segmented.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/known_planes.h"
#include "inverse_depth/carried_labels.h"
#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/region_map.h"
#include "over_time/pose_alignment.h"

namespace epcc {

/// Labels the samples of a grid by the planes of an earlier frame. Keeps its memory from frame to frame.
class KnownRegions {
 public:
  /// How strict to be.
  struct Rule {
    double max_residual = 3.0;       ///< sigma
    double pixels_per_sample = 1.0;  ///< samples of the grid that an independent one covers
    double error_scale = 1.0;        ///< alignPose()
  };

  /// The first labels of `map` become those of the known planes, on the samples that are expected to be theirs and lie
  /// within max_residual of them. Where a plane is expected and what is seen are brought together first: the expected
  /// plane with its covariance and the samples near it, as far as their error is independent.
  void label(const InverseDepthImage& image, const KnownPlanes& known, const Rule& rule, RegionMap& map,
             Continuation& continuation);
  /// Leaves of the image the samples without a label, where there are enough of them to be something.
  void hideLabelled(InverseDepthImage& image, const RegionMap& map);
  /// Takes that back.
  void showAll(InverseDepthImage& image);

 private:
  struct Expected {
    float x, y, z;  ///< q
    float c[6];     ///< covariance of q, xx xy xz yy yz zz
    float slope_factor;
    float max_square;  ///< of a residual, in variances of w
    Eigen::Matrix3d covariance;
  };
  void expect(const KnownPlanes& known, const UncertainPose& pose);
  void beginCarrying(const InverseDepthImage& image, const KnownPlanes& known, const Isometry3& pose);
  void lookNear(const InverseDepthImage& image, const KnownPlanes& known, const Isometry3& pose, const Rule& rule);
  void lookNearInRow(const InverseDepthImage& image, int row, const Rule& rule, CarriedLabels& carried);
  std::size_t takeLabels(const InverseDepthImage& image, int row, CarriedLabels& carried, std::int32_t* labels) const;
  void adapt(const Rule& rule);
  void labelSamples(const InverseDepthImage& image, const KnownPlanes& known, RegionMap& map,
                    Continuation& continuation);

  std::vector<Expected> expected_;      ///< by label
  std::vector<PlaneMoments> near_;      ///< by label
  std::vector<SeenPlane> seen_;         ///< the same, per plane
  std::vector<CarriedLabels> carried_;  ///< per view
  std::vector<float> all_w_;
  std::vector<int> block_counts_;
};

}  // namespace epcc
