// SPDX-License-Identifier: BSD-3-Clause
// Times the PCL class from cloud to PCL's types.
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <limits>
#include <vector>

#include "epcc_segmentation/pcl/epcc_segmentation.h"
#include "tests/bench/methods.h"

namespace epcc::bench {

namespace {

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr cloudOf(const DepthFrame& frame) {
  PointT none;
  none.x = none.y = none.z = std::numeric_limits<float>::quiet_NaN();
  const auto cloud = pcl::make_shared<pcl::PointCloud<PointT>>(static_cast<unsigned>(frame.width()),
                                                               static_cast<unsigned>(frame.height()), none);
  Eigen::Vector3d p;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column)
      if (frame.point(row, column, p)) (*cloud)[frame.index(row, column)].getVector3fMap() = p.cast<float>();
  return cloud;
}

template <typename PointT>
void segmentClouds(benchmark::State& state, const FrameOf& frame) {
  using Segmentation = EPCCSegmentation<PointT>;
  Segmentation segmentation;
  segmentation.setSensorModel(frame().sensor);
  segmentation.setInputCloud(cloudOf<PointT>(frame().view()));
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices;
  typename Segmentation::Centroids centroids;
  typename Segmentation::Covariances covariances;
  typename Segmentation::PointCloudL labels;
  for (auto _ : state) {
    segmentation.segment(models, inliers, centroids, covariances, labels, label_indices);
    if (segmentation.getStatus() != Status::Ok) return state.SkipWithError(segmentation.getErrorMessage().c_str());
  }
  state.counters["found"] = static_cast<double>(models.size());
}

}  // namespace

void pclClass(benchmark::State& state, const FrameOf& frame) {
  segmentClouds<pcl::PointXYZ>(state, frame);
}

void pclClassWithColours(benchmark::State& state, const FrameOf& frame) {
  segmentClouds<pcl::PointXYZRGB>(state, frame);
}

}  // namespace epcc::bench
