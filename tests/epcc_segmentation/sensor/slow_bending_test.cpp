// SPDX-License-Identifier: BSD-3-Clause
// Bending that is slower than a block is found by its share and length, and none where there is none.
#include "sensor/slow_bending.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "pi.h"
#include "sensor/image_blocks.h"

namespace epcc {
namespace {

constexpr int kWidth = 480, kHeight = 320, kSide = 32;
const PinholeCamera kCamera{kWidth, kHeight, 400.0, 400.0, 239.5, 159.5};
const SensorModel kSensor = SensorModel::axial(0.004, 0.0, 0.4);

/// An error of variance 1 with the autocorrelation exp(-r^2 / (2 length^2)): waves of random direction and phase.
class Waves {
 public:
  Waves(double length, unsigned seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> frequency(0.0, 1.0 / length);
    std::uniform_real_distribution<double> phase(0.0, 2.0 * kPi);
    for (int k = 0; k < kCount; ++k) waves_.push_back({frequency(engine), frequency(engine), phase(engine)});
  }
  double at(int row, int column) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += std::cos(wave.across * column + wave.down * row + wave.phase);
    return sum * std::sqrt(2.0 / kCount);
  }

 private:
  static constexpr int kCount = 30;
  struct Wave {
    double across, down, phase;
  };
  std::vector<Wave> waves_;
};

/// What is found on frames of a wall with grain and a bending of this share and length.
CorrelatedPart bendingOf(double share, double length, unsigned frames = 6, unsigned seed = 5) {
  SlowBending bending;
  ErrorCorrelation found;
  std::mt19937 engine(seed);
  std::normal_distribution<double> grain(0.0, 1.0);
  for (unsigned frame = 0; frame < frames; ++frame) {
    const Waves waves(length, frame);
    std::vector<float> depth;
    for (int row = 0; row < kHeight; ++row)
      for (int column = 0; column < kWidth; ++column)
        depth.push_back(static_cast<float>(2.0 + kSensor.sigmaZ(2.0) *
                                                     (std::sqrt(1.0 - share) * grain(engine) +
                                                      (share > 0.0 ? std::sqrt(share) * waves.at(row, column) : 0.0))));
    const DepthFrame wall = DepthFrame::fromDepth(depth.data(), kCamera);
    InverseDepthImage image;
    image.read(wall);
    PlaneSegmentation result;
    result.labels.assign(depth.size(), 1);
    PlaneFitter fitter;
    fitter.fit(wall, kSensor, 1, FitSamples(), 1, result);
    std::vector<BlockResiduals> blocks;
    for (int i = 0; i < ImageBlocks::placeCount(image, kSide); ++i)
      if (const auto block = measureBlock(image, ImageBlocks::place(image, kSide, i))) blocks.push_back(*block);
    found = bending.update({blocks.data(), blocks.size()}, image, {}, {result.labels, result.planes, kSensor, fitter});
  }
  EXPECT_EQ(found.blotches.share, 0.0);
  return found.bending;
}

TEST(SlowBending, IsFoundByShareAndLength) {
  for (const double length : {20.0, 40.0}) {
    const CorrelatedPart found = bendingOf(0.3, length);
    EXPECT_NEAR(found.share, 0.3, 0.1) << length;
    EXPECT_NEAR(found.length / length, 1.0, 0.25) << length;
  }
}

TEST(SlowBending, OfGrainAloneThereIsNone) {
  const CorrelatedPart found = bendingOf(0.0, 20.0);
  EXPECT_LT(found.share, 0.001);
}

/// The offsets of one frame's blocks are above what grain gives half the time.
TEST(SlowBending, ChanceIsSeldomTakenForIt) {
  int bent = 0;
  for (unsigned seed = 0; seed < 30; ++seed) bent += bendingOf(0.0, 20.0, 1, seed).share > 0.0 ? 1 : 0;
  EXPECT_LE(bent, 8);
}

TEST(SlowBending, IsNotMeasuredWithoutAFitAlongTheRaysOrOnAnotherGrid) {
  const std::vector<float> depth(kWidth * kHeight, 2.0f);
  const DepthFrame wall = DepthFrame::fromDepth(depth.data(), kCamera);
  InverseDepthImage image;
  image.read(wall);
  EXPECT_TRUE(SlowBending::canMeasure(wall, image, FitSamples()));
  EXPECT_FALSE(SlowBending::canMeasure(wall, image, {1, 0, false}));
  EXPECT_FALSE(SlowBending::canMeasure(wall.transposed(), image, FitSamples()));
  image.width /= 2;
  EXPECT_FALSE(SlowBending::canMeasure(wall, image, FitSamples()));
}

}  // namespace
}  // namespace epcc
