// SPDX-License-Identifier: BSD-3-Clause
// One line after the other by PCL's RANSAC.
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <algorithm>

#include "baselines/laser_points.h"
#include "baselines/quiet_pcl.h"

namespace epcc {

std::vector<MethodLine> ransacLines(const LaserScan& scan, const LaserMethodParameters& parameters) {
  const QuietPcl quiet;
  const std::vector<LaserPoint> points = laserPoints(scan);
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const LaserPoint& point : points)
    cloud->push_back({static_cast<float>(point.at.x()), static_cast<float>(point.at.y()), 0.0f});
  pcl::SACSegmentation<pcl::PointXYZ> ransac;
  ransac.setModelType(pcl::SACMODEL_LINE);
  ransac.setMethodType(pcl::SAC_RANSAC);
  ransac.setOptimizeCoefficients(true);
  ransac.setDistanceThreshold(parameters.distance);
  ransac.setMaxIterations(parameters.iterations);
  ransac.setInputCloud(cloud);

  const auto fewest = static_cast<std::size_t>(std::max(2, parameters.min_points));
  auto rest = pcl::make_shared<pcl::PointIndices>();
  for (std::size_t i = 0; i < points.size(); ++i) rest->indices.push_back(static_cast<pcl::index_t>(i));
  std::vector<MethodLine> lines;
  while (rest->indices.size() >= fewest) {
    pcl::PointIndices inliers;
    pcl::ModelCoefficients model;
    ransac.setIndices(rest);
    ransac.segment(inliers, model);
    if (inliers.indices.size() < fewest) break;
    std::sort(inliers.indices.begin(), inliers.indices.end());
    std::vector<LaserPoint> on_line;
    for (const auto i : inliers.indices) on_line.push_back(points[static_cast<std::size_t>(i)]);
    for (std::size_t first = 0; first < on_line.size();) {
      std::size_t last = first + 1;
      while (last < on_line.size() && !isJump(scan, on_line[last - 1], on_line[last], parameters.max_gap)) ++last;
      if (last - first >= fewest) lines.push_back(finishedLine(on_line, first, last));
      first = last;
    }
    // Inliers in pieces that are too short are used up as well, or the same line would be found for ever.
    auto left = pcl::make_shared<pcl::PointIndices>();
    std::set_difference(rest->indices.begin(), rest->indices.end(), inliers.indices.begin(), inliers.indices.end(),
                        std::back_inserter(left->indices));
    rest = left;
  }
  return lines;
}

}  // namespace epcc
