// SPDX-License-Identifier: BSD-3-Clause
// Region growing: the voxel filter's limits, parameters out of range, pixels of a voxel.
#include "baselines/region_growing_segmenter.h"

#include <gtest/gtest.h>

#include "baselines/registry.h"
#include "baselines/voxel_cloud.h"
#include "tests/baselines/baseline_frames.h"

namespace epcc::test {
namespace {

TEST(RegionGrowing, TooSmallALeafIsAnErrorNotAnUnfilteredRun) {
  // A room of metres in leaves of 0.1 mm: more than 1e12 voxels, beyond PCL's 32-bit index.
  RegionGrowingParameters parameters;
  parameters.leaf = {0.0001, 0.0};
  RegionGrowingSegmenter segmenter(parameters);
  PlaneSegmentation result;
  EXPECT_FALSE(segmenter.segment(inputOf(noisyRoom()), result));
  EXPECT_NE(segmenter.error().find("leaf"), std::string::npos) << segmenter.error();
  EXPECT_TRUE(result.planes.empty());
}

TEST(RegionGrowing, OneFarPixelOverflowsAFixedLeaf) {
  RenderedRoom room = noisyRoom();
  RegionGrowingSegmenter segmenter(paperParameters('a')->region_growing);
  PlaneSegmentation result;
  EXPECT_TRUE(segmenter.segment(inputOf(room), result)) << segmenter.error();
  room.depth[0] = 1e6f;
  EXPECT_FALSE(segmenter.segment(inputOf(room), result));
  EXPECT_NE(segmenter.error().find("leaf"), std::string::npos) << segmenter.error();
}

TEST(RegionGrowing, ParametersOutOfRangeAreErrors) {
  const auto errorOf = [](const RegionGrowingParameters& parameters) {
    RegionGrowingSegmenter segmenter(parameters);
    PlaneSegmentation result;
    EXPECT_FALSE(segmenter.segment(inputOf(noisyRoom()), result));
    return segmenter.error();
  };
  RegionGrowingParameters bad;
  bad.leaf = {0.0, 0.0};
  EXPECT_NE(errorOf(bad).find("leaf"), std::string::npos);
  bad = RegionGrowingParameters();
  bad.smoothness_degrees = std::nan("");
  EXPECT_NE(errorOf(bad).find("smoothness"), std::string::npos);
  bad = RegionGrowingParameters();
  bad.normal_neighbours = 2;
  EXPECT_NE(errorOf(bad).find("normal_neighbours"), std::string::npos);
  bad = RegionGrowingParameters();
  bad.max_cluster_size = bad.min_cluster_size - 1;
  EXPECT_NE(errorOf(bad).find("max_cluster_size"), std::string::npos);
}

TEST(RegionGrowing, SmallestClusterCountsVoxels) {
  RegionGrowingParameters parameters;
  parameters.min_cluster_size = 1000000;
  RegionGrowingSegmenter segmenter(parameters);
  PlaneSegmentation result;
  EXPECT_TRUE(segmenter.segment(inputOf(noisyRoom()), result)) << segmenter.error();
  EXPECT_TRUE(result.planes.empty());
}

TEST(VoxelCloud, EveryPointLiesInTheVoxelOfItsCentroid) {
  const RenderedRoom room = noisyRoom();
  const MeasuredPoints measured = measuredPoints(room.frame());
  ASSERT_EQ(measured.pixels.size(), 320u * 240u);
  const double leaf = 0.05;
  VoxelCloud voxels;
  ASSERT_EQ(makeVoxelCloud(measured, leaf, 30, voxels), "");
  ASSERT_GT(voxels.points->size(), 100u);
  ASSERT_LT(voxels.points->size(), measured.pixels.size() / 4);
  std::vector<Eigen::Vector3d> sums(voxels.points->size(), Eigen::Vector3d::Zero());
  std::vector<int> counts(voxels.points->size(), 0);
  for (std::size_t i = 0; i < measured.pixels.size(); ++i) {
    const std::int32_t voxel = voxels.point_of_measured[i];
    ASSERT_GE(voxel, 0);
    sums[static_cast<std::size_t>(voxel)] += (*measured.cloud)[i].getVector3fMap().cast<double>();
    ++counts[static_cast<std::size_t>(voxel)];
  }
  // The mean of the points of a voxel is the voxel's point: nothing was traced back to a wrong voxel.
  for (std::size_t v = 0; v < sums.size(); ++v) {
    ASSERT_GT(counts[v], 0);
    EXPECT_LT((sums[v] / counts[v] - (*voxels.points)[v].getVector3fMap().cast<double>()).norm(), 1e-4);
  }
}

TEST(VoxelCloud, SpacingIsThatOfNeighbouringPixels) {
  // A wall straight ahead at 2 m seen with f = 400: 5 mm from pixel to pixel.
  const std::vector<float> depth(64 * 48, 2.0f);
  const PinholeCamera camera{64, 48, 400.0, 400.0, 31.5, 23.5};
  EXPECT_NEAR(medianSpacing(DepthFrame::fromDepth(depth.data(), camera)), 0.005, 1e-5);
  const std::vector<float> nothing(64 * 48, 0.0f);
  EXPECT_EQ(medianSpacing(DepthFrame::fromDepth(nothing.data(), camera)), 0.0);
}

}  // namespace
}  // namespace epcc::test
