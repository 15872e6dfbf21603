// SPDX-License-Identifier: BSD-3-Clause
// setIndices: what is not among the indices is not seen.
#include "epcc_segmentation/pcl/epcc_segmentation.h"

#include <gtest/gtest.h>

#include "tests/epcc_segmentation/pcl/segmentation_output.h"

namespace epcc {
namespace {

using testing::countNear;
using testing::Output;
using testing::renderCamera;
using testing::Segmentation;
using testing::wallAndFloor;
using testing::Xyz;

TEST(EPCCSegmentation, IndicesLimitWhatIsSeen) {
  std::vector<int> truth;
  const auto cloud = renderCamera<Xyz>(wallAndFloor(), &truth);
  pcl::IndicesPtr wall(new pcl::Indices);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] == 0) wall->push_back(static_cast<int>(i));
  }
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setIndices(wall);
  Output<Xyz> out;
  out.run(segmentation);
  ASSERT_EQ(out.models.size(), 1u);
  EXPECT_EQ(countNear(out.models, wallAndFloor()[0]), 1);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] != 0) {
      EXPECT_EQ(out.labels[i].label, Segmentation::kNoPlane);
    }
  }

  // Every index twice and in reverse: the same.
  pcl::IndicesPtr twice(new pcl::Indices(wall->rbegin(), wall->rend()));
  twice->insert(twice->end(), wall->begin(), wall->end());
  segmentation.setIndices(twice);
  Output<Xyz> again;
  again.run(segmentation);
  EXPECT_EQ(again.labelValues(), out.labelValues());
}

TEST(EPCCSegmentation, RectangleOfIndices) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setIndices(10, 20, 40, 100);
  Output<Xyz> out;
  out.run(segmentation);
  ASSERT_EQ(out.models.size(), 1u);
  for (int row = 0; row < 120; ++row) {
    for (int column = 0; column < 160; ++column) {
      const bool inside = row >= 10 && row < 50 && column >= 20 && column < 120;
      if (!inside) {
        EXPECT_EQ(out.labels(column, row).label, Segmentation::kNoPlane);
      }
    }
  }
}

TEST(EPCCSegmentation, AllIndicesAreLikeNone) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  Output<Xyz> without;
  without.run(segmentation);
  pcl::IndicesPtr all(new pcl::Indices);
  for (std::size_t i = 0; i < cloud->size(); ++i) all->push_back(static_cast<int>(i));
  segmentation.setIndices(all);
  Output<Xyz> with;
  with.run(segmentation);
  EXPECT_EQ(with.labelValues(), without.labelValues());
  EXPECT_EQ(with.models.size(), 2u);
}

}  // namespace
}  // namespace epcc
