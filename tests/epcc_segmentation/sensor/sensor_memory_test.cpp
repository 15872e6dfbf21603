// SPDX-License-Identifier: BSD-3-Clause
// From the second frame on, measuring the sensor allocates nothing at all.
#include <gtest/gtest.h>

#include "epcc_segmentation/sensor_estimation.h"
#include "inverse_depth/inverse_depth_image.h"
#include "tests/support/failing_allocations.h"
#include "tests/support/rendered_room.h"

namespace epcc {
namespace {

InverseDepthImage imageWith(double a, int width, int height) {
  auto room = test::renderRoom(test::cornerPlanes(), test::testCamera(width, height));
  test::addNoise(room, SensorModel::axial(a, 0.0), 3);
  InverseDepthImage image;
  image.read(room.frame());
  return image;
}

/// The same, each value that of its neighbourhood of 8 x 8 pixels: blotches.
InverseDepthImage blotchyImage(double a, int width, int height) {
  const InverseDepthImage smooth = imageWith(0.0, width, height);
  const InverseDepthImage grainy = imageWith(a, width, height);
  InverseDepthImage image = smooth;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const std::size_t source = image.index(row / 8 * 8, column / 8 * 8);
      image.w[image.index(row, column)] += grainy.w[source] - smooth.w[source];
    }
  return image;
}

TEST(SensorMemory, IsAllThereAfterTheFirstFrame) {
  for (const int width : {320, 640}) {
    const int height = width * 3 / 4;
    const InverseDepthImage white = imageWith(0.003, width, height);
    const InverseDepthImage blotchy = blotchyImage(0.003, width, height);
    ASSERT_LT(SensorEstimator().update(white).blotch_share, SensorEstimator().update(blotchy).blotch_share);
    SensorEstimator estimator(6, 3);
    estimator.update(white);
    test::forgetAllocations();
    for (int frame = 0; frame < 20; ++frame) estimator.update(frame < 10 ? white : blotchy);
    estimator.reset();
    estimator.update(blotchy);
    EXPECT_EQ(test::largestAllocation(), 0u) << width;
  }
}

}  // namespace
}  // namespace epcc
