// SPDX-License-Identifier: BSD-3-Clause
// One plane after the other by RANSAC, after Table 3 of the paper.
#include "baselines/ransac_segmenter.h"

#include <pcl/segmentation/sac_segmentation.h>

#include <algorithm>
#include <random>
#include <utility>

#include "baselines/parameter_check.h"
#include "baselines/voxel_cloud.h"

namespace epcc {

std::string RansacParameters::validate() const {
  return firstProblem({leaf.validate("the voxel leaf"),
                       checkParameter("normal_neighbours", normal_neighbours, 3, 10000),
                       inlier_distance.validate("the inlier distance"),
                       checkParameter("normal_distance_weight", normal_distance_weight, 0.0, 1.0),
                       checkParameter("iterations", iterations, 1, 1000000),
                       checkParameter("min_plane_points", min_plane_points, 3, 1000000000),
                       checkParameter("max_planes", max_planes, 1, 1000000), checkParameter("seed", seed, 0, 1000000)});
}

namespace {

/// Fisher and Yates; the draws do not depend on the standard library's distributions.
void shuffle(int seed, pcl::Indices& indices) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  for (std::size_t i = indices.size(); i > 1; --i) std::swap(indices[i - 1], indices[random() % i]);
}

}  // namespace

bool RansacSegmenter::run(const SegmenterInput& input, PlaneSegmentation& result) {
  const std::string problem = parameters_.validate();
  if (!problem.empty()) return fail(problem);
  const MeasuredPoints measured = convert([&] { return measuredPoints(input.frame); });
  VoxelCloud voxels;
  const double spacing = medianSpacing(input.frame);
  const std::string voxel_problem =
      makeVoxelCloud(measured, parameters_.leaf.at(spacing), parameters_.normal_neighbours, voxels);
  if (!voxel_problem.empty()) return fail(voxel_problem);

  pcl::SACSegmentationFromNormals<pcl::PointXYZ, pcl::Normal> ransac;
  ransac.setModelType(pcl::SACMODEL_NORMAL_PLANE);
  ransac.setMethodType(pcl::SAC_RANSAC);
  ransac.setOptimizeCoefficients(true);
  ransac.setDistanceThreshold(parameters_.inlier_distance.at(spacing));
  ransac.setNormalDistanceWeight(parameters_.normal_distance_weight);
  ransac.setMaxIterations(parameters_.iterations);
  ransac.setInputCloud(voxels.points);
  ransac.setInputNormals(voxels.normals);

  const std::size_t fewest = static_cast<std::size_t>(parameters_.min_plane_points);
  std::vector<std::int32_t> point_labels(voxels.points->size(), 0);
  auto rest = pcl::make_shared<pcl::PointIndices>();
  for (std::size_t i = 0; i < voxels.points->size(); ++i) rest->indices.push_back(static_cast<pcl::index_t>(i));
  if (parameters_.seed != 0) shuffle(parameters_.seed, rest->indices);
  std::int32_t label = 0;
  while (label < parameters_.max_planes && rest->indices.size() >= fewest) {
    pcl::PointIndices inliers;
    pcl::ModelCoefficients plane;
    ransac.setIndices(rest);
    ransac.segment(inliers, plane);
    if (inliers.indices.size() < fewest) break;
    ++label;
    for (const auto point : inliers.indices) point_labels[static_cast<std::size_t>(point)] = label;
    auto left = pcl::make_shared<pcl::PointIndices>();
    std::copy_if(rest->indices.begin(), rest->indices.end(), std::back_inserter(left->indices),
                 [&](pcl::index_t point) { return point_labels[static_cast<std::size_t>(point)] == 0; });
    rest = left;
  }
  labelPixels(measured, voxels, point_labels, result.labels);
  fitLabels(input, label, result);
  return true;
}

}  // namespace epcc
