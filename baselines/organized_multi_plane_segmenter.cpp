// SPDX-License-Identifier: BSD-3-Clause
// Integral-image normals, connected components of alike planes, refinement.
#include "baselines/organized_multi_plane_segmenter.h"

#include <pcl/features/integral_image_normal.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include <unordered_map>

#include "baselines/frame_cloud.h"
#include "baselines/parameter_check.h"

namespace epcc {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Segmentation = pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label>;
using Refinement = pcl::PlaneRefinementComparator<pcl::PointXYZ, pcl::Normal, pcl::Label>;

pcl::PointCloud<pcl::Normal>::Ptr integralNormals(const Cloud::Ptr& cloud, const OrganizedMultiPlaneParameters& p) {
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod(estimation.COVARIANCE_MATRIX);
  estimation.setMaxDepthChangeFactor(static_cast<float>(p.max_depth_change));
  estimation.setNormalSmoothingSize(static_cast<float>(p.normal_smoothing));
  estimation.setInputCloud(cloud);
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  estimation.compute(*normals);
  return normals;
}

}  // namespace

std::string OrganizedMultiPlaneParameters::validate() const {
  return firstProblem({checkParameter("max_depth_change", max_depth_change, 1e-9, 10.0),
                       checkParameter("normal_smoothing", normal_smoothing, 3.0, 1000.0),
                       checkParameter("min_inliers", min_inliers, 3, 1000000000),
                       checkParameter("angle_degrees", angle_degrees, 1e-6, 90.0),
                       checkParameter("distance", distance, 1e-9, 100.0),
                       checkParameter("max_curvature", max_curvature, 1e-12, 1.0),
                       checkParameter("refinement_distance", refinement_distance, 1e-9, 100.0)});
}

bool OrganizedMultiPlaneSegmenter::run(const SegmenterInput& input, PlaneSegmentation& result) {
  const std::string problem = parameters_.validate();
  if (!problem.empty()) return fail(problem);
  const int smallest = 2 * static_cast<int>(parameters_.normal_smoothing) + 1;
  if (result.width < smallest || result.height < smallest)
    return fail("the image must be at least " + std::to_string(smallest) + " pixels wide and high: twice the window " +
                "of the normals");
  const Cloud::Ptr cloud = convert([&] { return organizedCloud(input.frame); });

  Segmentation segmentation;
  segmentation.setMinInliers(static_cast<unsigned>(parameters_.min_inliers));
  segmentation.setAngularThreshold(parameters_.angle_degrees * M_PI / 180.0);
  segmentation.setDistanceThreshold(parameters_.distance);
  segmentation.setMaximumCurvature(parameters_.max_curvature);
  const auto refinement = pcl::make_shared<Refinement>();
  refinement->setDistanceThreshold(static_cast<float>(parameters_.refinement_distance), false);
  segmentation.setRefinementComparator(refinement);
  segmentation.setInputCloud(cloud);
  segmentation.setInputNormals(integralNormals(cloud, parameters_));

  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices;
  std::vector<Eigen::Vector4f, Eigen::aligned_allocator<Eigen::Vector4f>> centroids;
  std::vector<Eigen::Matrix3f, Eigen::aligned_allocator<Eigen::Matrix3f>> covariances;
  auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
  segmentation.segment(models, inliers, centroids, covariances, *labels, label_indices);
  if (models.empty()) return true;

  // The planes are some of the labelled components; the refinement changes the label image and, unlike it, leaves
  // pixels in the lists of the components they came from: the image counts.
  std::unordered_map<std::uint32_t, std::int32_t> plane_of_component;
  for (std::size_t i = 0; i < inliers.size(); ++i)
    plane_of_component[(*labels)[static_cast<std::size_t>(inliers[i].indices[0])].label] =
        static_cast<std::int32_t>(i + 1);
  segmentation.refine(models, inliers, labels, label_indices);

  for (int row = 0; row < result.height; ++row)
    for (int column = 0; column < result.width; ++column) {
      const auto plane = plane_of_component.find(labels->at(column, row).label);
      if (plane != plane_of_component.end()) result.labels[input.frame.index(row, column)] = plane->second;
    }
  fitLabels(input, static_cast<std::int32_t>(models.size()), result);
  return true;
}

}  // namespace epcc
