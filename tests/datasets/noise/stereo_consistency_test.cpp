// SPDX-License-Identifier: BSD-3-Clause
// The covariances hold for an error in blotches and slow bending, with the sensor measured on the frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "datasets/noise/sensor_noise.h"
#include "datasets/rendered/scene.h"
#include "epcc_segmentation/plane_extractor.h"
#include "tests/datasets/noise/noisy_desk.h"

namespace epcc {
namespace {

TEST(StereoConsistency, TheMeasuredSensorHasItsBendingInTheCovariances) {
  const LabelledFrame exact = renderScene("a", 1);
  NoiseOptions stereo;
  stereo.kind = NoiseKind::Stereo;
  PlaneExtractor extractor;
  test::Mean mean;
  for (int run = 0; run < 30; ++run) {
    LabelledFrame frame = exact;
    applyNoise(frame, stereo, static_cast<std::uint64_t>(run));
    PlaneSegmentation result;
    ASSERT_TRUE(extractor.extract(test::view(frame), result));
    const auto planes = test::planesOf(exact);
    for (std::size_t k = 0; k < planes.size(); ++k)
      if (const Plane* plane = test::planeOn(result, frame, k))
        mean.add(test::normalisedSquaredError(*plane, planes[k]));
  }
  EXPECT_GT(mean.count, 100);
  EXPECT_NEAR(mean.value(), 3.0, 0.9);  // 8.5 without the bending
}

}  // namespace
}  // namespace epcc
