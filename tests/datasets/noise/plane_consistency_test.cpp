// SPDX-License-Identifier: BSD-3-Clause
// Over many noisy renderings the planes' errors are as large as their covariances say.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/plane_fit.h"
#include "tests/datasets/noise/noisy_desk.h"

namespace epcc {
namespace {

class PlaneConsistency : public test::NoisyDesk {};
using test::Mean;
using test::normalisedSquaredError;
using test::planeOn;
using test::view;

TEST_P(PlaneConsistency, TheErrorsOfFittedPlanesAreAsLargeAsTheCovariancesSay) {
  Mean mean;
  for (int run = 0; run < 500; ++run) {
    const LabelledFrame frame = noisy(run);
    for (std::size_t k = 0; k < truths_.size(); ++k) {  // one at a time, for they come back in order of size
      PlaneSegmentation one;
      for (const std::uint16_t label : frame.labels.data) one.labels.push_back(label == k + 1 ? 1 : 0);
      ASSERT_TRUE(fitPlanes(view(frame), sensor(), 1, one));
      mean.add(normalisedSquaredError(one.planes.at(0), truths_[k]));
    }
  }
  EXPECT_NEAR(mean.value(), 3.0, 0.3);
}

TEST_P(PlaneConsistency, SoAreThoseOfSegmentedFramesWithTheSensorGivenAndMeasured) {
  for (const bool measured : {false, true}) {
    PlaneExtractor extractor(Parameters(), measured ? std::nullopt : std::optional<SensorModel>(sensor()));
    Mean mean;
    for (int run = 0; run < 200; ++run) {
      const LabelledFrame frame = noisy(run);
      PlaneSegmentation result;
      ASSERT_TRUE(extractor.extract(view(frame), result));
      for (std::size_t k = 0; k < truths_.size(); ++k)
        if (const Plane* plane = planeOn(result, frame, k)) mean.add(normalisedSquaredError(*plane, truths_[k]));
    }
    EXPECT_GT(mean.count, 600) << measured;
    EXPECT_NEAR(mean.value(), 3.0, 0.9) << measured;  // borders go to the plane that suits them
  }
}

INSTANTIATE_TEST_SUITE_P(Length, PlaneConsistency, ::testing::Values(0.4, 2.0, 4.0));

}  // namespace
}  // namespace epcc
