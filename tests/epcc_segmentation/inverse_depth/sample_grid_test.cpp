// SPDX-License-Identifier: BSD-3-Clause
// The grid of samples, and what lengths and areas are on it.
#include "inverse_depth/sample_grid.h"

#include <gtest/gtest.h>

#include "tests/epcc_segmentation/inverse_depth/region_fixture.h"

namespace {

using epcc::InverseDepthImage;
using epcc::InverseDepthParameters;
using epcc::onGrid;
using epcc::SensorModel;

TEST(SampleGrid, TheDefaultStrideIsOneForEvery320Columns) {
  EXPECT_EQ(epcc::strideFor(64, 0), 1);
  EXPECT_EQ(epcc::strideFor(320, 0), 1);
  EXPECT_EQ(epcc::strideFor(479, 0), 1);
  EXPECT_EQ(epcc::strideFor(512, 0), 2);
  EXPECT_EQ(epcc::strideFor(640, 0), 2);
  EXPECT_EQ(epcc::strideFor(848, 0), 3);
  EXPECT_EQ(epcc::strideFor(1280, 0), 4);
  EXPECT_EQ(epcc::strideFor(4096, 0), 4);
  EXPECT_EQ(epcc::strideFor(4096, 1), 1);
  EXPECT_EQ(epcc::strideFor(64, 8), 8);
}

TEST(SampleGrid, AScanOfFewRingsIsASmallImage) {
  EXPECT_EQ(epcc::longerSide(640, 480), 640);
  EXPECT_EQ(epcc::longerSide(1080, 1920), 1920);
  EXPECT_EQ(epcc::longerSide(1024, 64), 128);
  EXPECT_EQ(epcc::longerSide(128, 2048), 256);
}

TEST(SampleGrid, ParametersInPixelsBecomeOnesInSamples) {
  const InverseDepthParameters pixels;
  const InverseDepthParameters two = onGrid(pixels, 640, 2);
  EXPECT_EQ(two.min_points, 15);
  EXPECT_EQ(two.expert.lines.min_samples, 3);
  EXPECT_EQ(two.expert.lines.max_gap_pixels, 2);  // a reach of three samples
  EXPECT_EQ(two.expert.planes.min_overlap_pixels, 2);
  EXPECT_EQ(two.expert.planes.min_points, 10);
  EXPECT_EQ(two.expert.merging.min_contacts, 2);
  EXPECT_EQ(two.expert.refinement.crease_vote_pixels, 3);
  const InverseDepthParameters four = onGrid(pixels, 1280, 4);
  EXPECT_EQ(four.expert.lines.min_samples, 3) << "two samples always lie on a line";
  EXPECT_EQ(four.expert.lines.max_gap_pixels, 0) << "a reach of six pixels holds one sample of four, not two";
  EXPECT_EQ(four.expert.merging.min_bridge_pixels, 1);
  const InverseDepthParameters small = onGrid(pixels, 320, 1);
  EXPECT_EQ(small.expert.lines.min_samples, 3) << "the lengths of half the image, where all is half as wide";
  EXPECT_EQ(small.expert.planes.min_points, 10);
  EXPECT_EQ(small.min_points, 60) << "the user's";
  EXPECT_EQ(onGrid(pixels, 32, 1).expert.planes.min_points, 3) << "no image is worth less than one of 160 pixels";
  EXPECT_EQ(onGrid(pixels, 4096, 1).expert.lines.min_samples, 6);
  EXPECT_EQ(four.line_k_max, pixels.line_k_max) << "what is in sigma stays";
  EXPECT_EQ(four.expert.evidence.min_evidence, pixels.expert.evidence.min_evidence);
}

TEST(SampleGrid, ASampleIsWorthAsManyIndependentOnesAsItsPixels) {
  const SensorModel sensor = SensorModel::axial(0.002, 0.003, 8.0);
  EXPECT_DOUBLE_EQ(onGrid(sensor, 4).pixelsPerSample(), sensor.pixelsPerSample() / 16.0);
  EXPECT_DOUBLE_EQ(onGrid(sensor, 4).sigmaZ(2.0), sensor.sigmaZ(2.0));
  EXPECT_DOUBLE_EQ(onGrid(SensorModel::axial(0.002, 0.0, 1.0), 4).pixelsPerSample(), 1.0);
}

TEST(SampleGrid, SamplesAreThePixelsInTheMiddleOfTheirBlocks) {
  for (const auto& [width, height] : {std::pair{7, 5}, std::pair{8, 3}, std::pair{1, 9}, std::pair{2, 1}}) {
    const auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(width, height));
    const InverseDepthImage image = epcc::test::imageOf(room);
    for (int stride = 2; stride <= 4; ++stride) {
      InverseDepthImage samples;
      samples.sample(image, stride);
      samples.weigh(epcc::test::kWhite, image.placeVariance());
      ASSERT_GE(samples.width, 1);
      ASSERT_EQ(samples.w.size(), static_cast<std::size_t>(samples.width) * static_cast<std::size_t>(samples.height));
      for (int row = 0; row < samples.height; ++row)
        for (int column = 0; column < samples.width; ++column) {
          const int r = std::min(stride / 2 + row * stride, height - 1);
          const int c = std::min(stride / 2 + column * stride, width - 1);
          EXPECT_EQ(epcc::sampleAt(r, stride, height), row);
          EXPECT_EQ(epcc::sampleAt(c, stride, width), column);
          const std::size_t sample = samples.index(row, column), pixel = image.index(r, c);
          EXPECT_EQ(samples.w[sample], image.w[pixel]);
          EXPECT_EQ(samples.weight[sample], image.weight[pixel]) << "the noise of a pixel, not of a block";
          EXPECT_EQ(samples.ray(row, column), image.ray(r, c));
        }
    }
  }
}

}  // namespace
