// SPDX-License-Identifier: BSD-3-Clause
// Voxel filter whose points are traced back to the pixels, and normals without NaN.
#include "baselines/voxel_cloud.h"

#include <pcl/features/normal_3d.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace epcc {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// Empty if pcl::VoxelGrid's integer indices hold for this cloud. Stricter than PCL's own test by a voxel a side.
std::string checkLeaf(const Cloud& cloud, double leaf) {
  constexpr double kMaxCells = std::numeric_limits<std::int32_t>::max();
  Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array3d high = -low;
  for (const auto& point : cloud) {
    const Eigen::Array3d p = point.getVector3fMap().cast<double>().array();
    low = low.min(p);
    high = high.max(p);
  }
  constexpr double kMaxCoordinate = 1e12;  // metres; PCL sums coordinates and their squares in single precision
  if (std::max(low.abs().maxCoeff(), high.abs().maxCoeff()) > kMaxCoordinate)
    return "there are points farther than 1e12 m: PCL's single precision would overflow";
  const Eigen::Array3d cells = (high / leaf).floor() - (low / leaf).floor() + 3.0;
  const double farthest = std::max(low.abs().maxCoeff(), high.abs().maxCoeff()) / leaf;
  if (cells.prod() < kMaxCells && farthest < 0.5 * kMaxCells) return {};
  std::ostringstream text;
  text << "the voxel leaf of " << leaf << " m is too small for a cloud of " << (high - low)(0) << " x "
       << (high - low)(1) << " x " << (high - low)(2) << " m: PCL's voxel index would overflow";
  return text.str();
}

/// The voxel index of each point, with VoxelGrid's own arithmetic.
std::vector<std::int32_t> voxelIndices(const Cloud& cloud, const pcl::VoxelGrid<pcl::PointXYZ>& grid) {
  const Eigen::Vector3f leaf = grid.getLeafSize();
  const Eigen::Array3f inverse = Eigen::Array3f::Ones() / leaf.array();
  const Eigen::Vector3i low = grid.getMinBoxCoordinates();
  const Eigen::Vector3i step = grid.getDivisionMultiplier();
  std::vector<std::int32_t> indices;
  indices.reserve(cloud.size());
  for (const auto& point : cloud) {
    std::int32_t index = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const float cell = std::floor(point.data[axis] * inverse(axis)) - static_cast<float>(low(axis));
      index += static_cast<std::int32_t>(cell) * step(axis);
    }
    indices.push_back(index);
  }
  return indices;
}

}  // namespace

std::string makeVoxelCloud(const MeasuredPoints& measured, double leaf, int neighbours, VoxelCloud& result) {
  result.points = pcl::make_shared<Cloud>();
  result.normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  result.point_of_measured.assign(measured.pixels.size(), -1);
  if (measured.cloud->size() < 3) return {};
  if (!(leaf > 0.0 && std::isfinite(leaf))) return "the measured points do not tell a size of the voxel leaf";
  const std::string problem = checkLeaf(*measured.cloud, leaf);
  if (!problem.empty()) return problem;

  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(measured.cloud);
  const float leaf_size = static_cast<float>(leaf);
  grid.setLeafSize(leaf_size, leaf_size, leaf_size);
  const auto centroids = pcl::make_shared<Cloud>();
  grid.filter(*centroids);

  // VoxelGrid's points come in the order of their voxel index: the rank of the index is the point.
  const std::vector<std::int32_t> indices = voxelIndices(*measured.cloud, grid);
  std::vector<std::int32_t> occupied = indices;
  std::sort(occupied.begin(), occupied.end());
  occupied.erase(std::unique(occupied.begin(), occupied.end()), occupied.end());
  if (occupied.size() != centroids->size()) return "pcl::VoxelGrid did not give one point a voxel";

  pcl::PointCloud<pcl::Normal> normals;
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(centroids);
  estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setKSearch(neighbours);
  estimation.compute(normals);

  std::vector<std::int32_t> kept(centroids->size(), -1);
  for (std::size_t i = 0; i < centroids->size(); ++i) {
    const pcl::Normal& normal = normals[i];
    if (!normal.getNormalVector3fMap().allFinite() || !std::isfinite(normal.curvature)) continue;
    kept[i] = static_cast<std::int32_t>(result.points->size());
    result.points->push_back((*centroids)[i]);
    result.normals->push_back(normal);
  }
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const auto place = std::lower_bound(occupied.begin(), occupied.end(), indices[i]) - occupied.begin();
    result.point_of_measured[i] = kept[static_cast<std::size_t>(place)];
  }
  return {};
}

void labelPixels(const MeasuredPoints& measured, const VoxelCloud& voxels,
                 const std::vector<std::int32_t>& point_labels, std::vector<std::int32_t>& pixel_labels) {
  for (std::size_t i = 0; i < measured.pixels.size(); ++i) {
    const std::int32_t point = voxels.point_of_measured[i];
    if (point >= 0) pixel_labels[measured.pixels[i]] = point_labels[static_cast<std::size_t>(point)];
  }
}

}  // namespace epcc
