// SPDX-License-Identifier: BSD-3-Clause
// Memory that runs out at any moment of a call: empty outputs, a status, an error line at most, and no exception.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "epcc_segmentation/pcl/epcc_segmentation.h"
#include "tests/epcc_segmentation/pcl/test_clouds.h"
#include "tests/support/failing_allocations.h"

namespace epcc {
namespace {

using Segmentation = EPCCSegmentation<pcl::PointXYZ>;

/// A small wall and floor: the test segments it some hundred times.
pcl::PointCloud<pcl::PointXYZ>::Ptr smallCloud() {
  const auto ray = [](int row, int column) {
    return Eigen::Vector3d((column - 19.5) / 32.0, (row - 14.5) / 32.0, 1.0);
  };
  return testing::renderRays<pcl::PointXYZ>(40, 30, testing::wallAndFloor(), ray);
}

class PclOutOfMemory : public ::testing::TestWithParam<int> {
 protected:
  PclOutOfMemory() : cloud_(smallCloud()) {}

  /// A new object makes the call of the parameter.
  void callWith(long allocations) {
    Segmentation segmentation;
    segmentation.setInputCloud(cloud_);
    segmentation.setIndices(0, 0, 30, 40);
    labels_.reset();
    ::testing::internal::CaptureStderr();
    {
      const test::FailingAllocations memory(allocations);
      EXPECT_NO_THROW(call(segmentation));
      ran_out_ = memory.happened();
    }
    printed_ = ::testing::internal::GetCapturedStderr();
    status_ = segmentation.getStatus();
    error_ = segmentation.getErrorMessage();
  }

  void call(Segmentation& segmentation) {
    switch (GetParam()) {
      case 0:
        return segmentation.segment(models_, inliers_);
      case 1:
        return segmentation.segment(models_, inliers_, centroids_, covariances_, more_labels_, label_indices_);
      case 2:
        return segmentation.segment(regions_);
      case 3:
        return segmentation.segmentAndRefine(regions_);
      case 4:
        return segmentation.segmentAndRefine(regions_, models_, inliers_, labels_, label_indices_, boundaries_);
      default:
        return segmentation.extract(inliers_);
    }
  }

  std::size_t outputs() const {
    return models_.size() + inliers_.size() + centroids_.size() + covariances_.size() + more_labels_.size() +
           (labels_ ? labels_->size() : 0) + label_indices_.size() + boundaries_.size() + regions_.size();
  }

  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud_;
  std::vector<pcl::ModelCoefficients> models_;
  std::vector<pcl::PointIndices> inliers_, label_indices_, boundaries_;
  Segmentation::PlanarRegions regions_;
  Segmentation::Centroids centroids_;
  Segmentation::Covariances covariances_;
  pcl::PointCloud<pcl::Label> more_labels_;
  pcl::PointCloud<pcl::Label>::Ptr labels_;
  bool ran_out_ = true;
  std::string printed_, error_;
  Status status_ = Status::Ok;
};

TEST_P(PclOutOfMemory, AtAnyAllocationIsAStatus) {
  int refused = 0;
  for (long allocations = 0; ran_out_; ++allocations) {
    ASSERT_NO_FATAL_FAILURE(callWith(allocations));
    if (status_ == Status::Ok) continue;
    ++refused;
    ASSERT_EQ(status_, Status::OutOfMemory);
    ASSERT_EQ(error_, "out of memory");
    ASSERT_EQ(outputs(), 0U) << allocations;
    ASSERT_LE(std::count(printed_.begin(), printed_.end(), '\n'), 1) << printed_;
    ASSERT_FALSE(HasFailure()) << allocations;
  }
  EXPECT_EQ(status_, Status::Ok);
  EXPECT_GT(outputs(), 0U);
  EXPECT_GT(refused, 20);
}

// The outputs of one call are those of the next: nothing as large as the cloud is allocated then.
TEST(PclMemory, IsKeptFromCallToCall) {
  const auto cloud = smallCloud();
  EPCCSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setSensorModel(SensorModel::axial(0.003, 0.0));
  segmentation.setInputCloud(cloud);
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices;
  EPCCSegmentation<pcl::PointXYZ>::Centroids centroids;
  EPCCSegmentation<pcl::PointXYZ>::Covariances covariances;
  pcl::PointCloud<pcl::Label> labels;
  const auto segment = [&] { segmentation.segment(models, inliers, centroids, covariances, labels, label_indices); };
  segment();
  ASSERT_FALSE(inliers.empty());
  const pcl::Indices first = inliers.front().indices;
  test::forgetAllocations();
  segment();
  EXPECT_LT(test::largestAllocation(), cloud->size());
  EXPECT_EQ(inliers.front().indices, first);
  EXPECT_EQ(label_indices.front().indices, first);
}

INSTANTIATE_TEST_SUITE_P(EachCall, PclOutOfMemory, ::testing::Range(0, 6));

}  // namespace
}  // namespace epcc
