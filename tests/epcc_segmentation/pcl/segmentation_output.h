// SPDX-License-Identifier: BSD-3-Clause
// Everything segment() gives, and how its planes are compared with the rendered ones.
#pragma once

#include <algorithm>
#include <vector>

#include "epcc_segmentation/pcl/epcc_segmentation.h"
#include "tests/epcc_segmentation/pcl/test_clouds.h"

namespace epcc::testing {

template <typename PointT>
struct Output {
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  typename EPCCSegmentation<PointT>::Centroids centroids;
  typename EPCCSegmentation<PointT>::Covariances covariances;
  pcl::PointCloud<pcl::Label> labels;
  std::vector<pcl::PointIndices> label_indices;

  void run(EPCCSegmentation<PointT>& segmentation) {
    segmentation.segment(models, inliers, centroids, covariances, labels, label_indices);
  }
  std::vector<std::uint32_t> labelValues() const {
    std::vector<std::uint32_t> values;
    for (const auto& label : labels) values.push_back(label.label);
    return values;
  }
};

using Xyz = pcl::PointXYZ;
using Segmentation = EPCCSegmentation<Xyz>;

/// Largest difference of a plane's coefficients from the given ones.
inline double difference(const pcl::ModelCoefficients& model, const Eigen::Vector4d& truth) {
  return (Eigen::Map<const Eigen::Vector4f>(model.values.data()).cast<double>() - truth).cwiseAbs().maxCoeff();
}

inline int countNear(const std::vector<pcl::ModelCoefficients>& models, const Eigen::Vector4d& truth) {
  return static_cast<int>(
      std::count_if(models.begin(), models.end(), [&](const auto& model) { return difference(model, truth) < 0.01; }));
}

}  // namespace epcc::testing
