// SPDX-License-Identifier: BSD-3-Clause
// Region growing after Table 3 of the paper.
#include "baselines/region_growing_segmenter.h"

#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>

#include "baselines/parameter_check.h"
#include "baselines/voxel_cloud.h"

namespace epcc {

std::string RegionGrowingParameters::validate() const {
  return firstProblem({leaf.validate("the voxel leaf"),
                       checkParameter("normal_neighbours", normal_neighbours, 3, 10000),
                       checkParameter("growing_neighbours", growing_neighbours, 1, 10000),
                       checkParameter("smoothness_degrees", smoothness_degrees, 1e-6, 90.0),
                       checkParameter("curvature_threshold", curvature_threshold, 1e-9, 1.0),
                       checkParameter("min_cluster_size", min_cluster_size, 1, 1000000000),
                       checkParameter("max_cluster_size", max_cluster_size, min_cluster_size, 1000000000)});
}

bool RegionGrowingSegmenter::run(const SegmenterInput& input, PlaneSegmentation& result) {
  const std::string problem = parameters_.validate();
  if (!problem.empty()) return fail(problem);
  const MeasuredPoints measured = convert([&] { return measuredPoints(input.frame); });
  VoxelCloud voxels;
  const double leaf = parameters_.leaf.at(medianSpacing(input.frame));
  const std::string voxel_problem = makeVoxelCloud(measured, leaf, parameters_.normal_neighbours, voxels);
  if (!voxel_problem.empty()) return fail(voxel_problem);
  if (voxels.points->empty()) return true;

  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setInputCloud(voxels.points);
  growing.setInputNormals(voxels.normals);
  growing.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  growing.setNumberOfNeighbours(static_cast<unsigned>(parameters_.growing_neighbours));
  growing.setMinClusterSize(parameters_.min_cluster_size);
  growing.setMaxClusterSize(parameters_.max_cluster_size);
  growing.setSmoothnessThreshold(static_cast<float>(parameters_.smoothness_degrees * M_PI / 180.0));
  growing.setCurvatureThreshold(static_cast<float>(parameters_.curvature_threshold));
  std::vector<pcl::PointIndices> clusters;
  growing.extract(clusters);

  std::vector<std::int32_t> point_labels(voxels.points->size(), 0);
  std::int32_t label = 0;
  for (const auto& cluster : clusters) {
    ++label;
    for (const auto point : cluster.indices) point_labels[static_cast<std::size_t>(point)] = label;
  }
  labelPixels(measured, voxels, point_labels, result.labels);
  fitLabels(input, label, result);
  return true;
}

}  // namespace epcc
