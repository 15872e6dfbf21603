// SPDX-License-Identifier: BSD-3-Clause
// The stereo noise on single planes and on a box in front of a wall: amplitude, correlation, steps, shadows, holes.
#include "datasets/noise/stereo_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "datasets/noise/noise_field.h"
#include "datasets/rendered/scene.h"
#include "datasets/rendered/scene_renderer.h"

namespace epcc {
namespace {

const PinholeCamera kCamera = sceneCamera();

DepthImage wall(double z) {
  return renderPlane({0.0, 0.0, -1.0, z}, kCamera);
}

// The error alone: no holes, outliers or edges.
StereoNoise errorsOnly() {
  StereoNoise noise;
  noise.outlier_share = 0.0;
  noise.hole_share = 0.0;
  noise.shadows = false;
  return noise;
}

// Error of the inverse depth at the pixels with depth, else NaN.
Image<double> errorOf(const DepthImage& noisy, const DepthImage& clean) {
  Image<double> error(clean.width, clean.height, std::nan(""));
  for (std::size_t i = 0; i < clean.data.size(); ++i)
    if (noisy.data[i] > 0.0F)
      error.data[i] = 1.0 / static_cast<double>(noisy.data[i]) - 1.0 / static_cast<double>(clean.data[i]);
  return error;
}

double meanProduct(const Image<double>& error, int down, int right) {
  double sum = 0.0, count = 0.0;
  for (int row = 0; row + down < error.height; ++row)
    for (int column = 0; column + right < error.width; ++column) {
      const double both = error.at(row, column) * error.at(row + down, column + right);
      if (std::isnan(both)) continue;
      sum += both;
      count += 1.0;
    }
  return sum / count;
}

// Pooled over seeds: blotches leave few independent samples in one frame.
double pooled(const DepthImage& clean, const StereoNoise& noise, int down, int right) {
  double sum = 0.0;
  constexpr int kSeeds = 6;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
    sum += meanProduct(errorOf(stereoDepth(clean, kCamera, noise, seed), clean), down, right);
  return sum / kSeeds;
}

double shareOfZeros(const DepthImage& depth) {
  return static_cast<double>(std::count(depth.data.begin(), depth.data.end(), 0.0F)) /
         static_cast<double>(depth.data.size());
}

TEST(StereoNoise, IsConstantInInverseDepth) {
  for (const double z : {1.0, 2.0, 4.0})
    EXPECT_NEAR(std::sqrt(pooled(wall(z), errorsOnly(), 0, 0)), 0.0045, 0.0006) << z;
}

TEST(StereoNoise, GrowsOnSlantedSurfaces) {
  const double slope = 2.0, length = std::hypot(1.0, slope);
  const DepthImage clean = renderPlane({-slope / length, 0.0, -1.0 / length, 3.0 / length}, kCamera);
  const Image<double> error = errorOf(stereoDepth(clean, kCamera, errorsOnly(), 1), clean);
  double sum = 0.0, count = 0.0;
  for (int row = 0; row < error.height; ++row)
    for (int column = 200; column < 280; ++column) {  // w = (1 + 2 u) / 3
      const double w = (1.0 + slope * (column - kCamera.cx) / kCamera.fx) / 3.0;
      const double tan2 = (slope / 3.0) * (slope / 3.0) / (w * w);
      sum += error.at(row, column) * error.at(row, column) / (1.0 + tan2);
      count += 1.0;
    }
  EXPECT_NEAR(std::sqrt(sum / count), 0.0045, 0.0015);
}

// Bounds: the real figures of docs/reference/evaluation.md (registered grid, rows) at the same lags over 1.6.
TEST(StereoNoise, ComesInBlotchesAsOnRealFrames) {
  const double variance = pooled(wall(2.0), errorsOnly(), 0, 0);
  struct Bound {
    int lag;
    double low, high;
  };
  for (const Bound& b : {Bound{1, 0.85, 0.98}, Bound{2, 0.78, 0.94}, Bound{5, 0.55, 0.83}, Bound{10, 0.18, 0.55},
                         Bound{15, 0.0, 0.40}}) {
    for (const double r : {pooled(wall(2.0), errorsOnly(), 0, b.lag), pooled(wall(2.0), errorsOnly(), b.lag, 0)}) {
      EXPECT_GT(r / variance, b.low) << b.lag;
      EXPECT_LT(r / variance, b.high) << b.lag;
    }
  }
}

TEST(StereoNoise, HasBlotchesOfTheSameSizeOnTheSensorWhenTheGridIsFiner) {
  StereoNoise fine = errorsOnly();
  fine.grid_scale = 1.6;
  const double native = pooled(wall(1.0), errorsOnly(), 0, 5) / pooled(wall(1.0), errorsOnly(), 0, 0);
  const double registered = pooled(wall(1.0), fine, 0, 8) / pooled(wall(1.0), fine, 0, 0);
  EXPECT_NEAR(native, registered, 0.08);
}

TEST(StereoNoise, DeliversStepsOfDisparityInWholeMillimetres) {
  const StereoNoise noise = errorsOnly();
  const DepthImage depth = stereoDepth(wall(3.0), kCamera, noise, 2);
  for (const float z : depth.data) {
    const double mm = 1000.0 * static_cast<double>(z);
    ASSERT_NEAR(mm, std::round(mm), 1e-3);
    // At 3 m a step is 24 mm: the depth lies within half a millimetre of one.
    const double disparity = kCamera.fx * noise.baseline / noise.disparity_step;
    ASSERT_NEAR(mm, 1000.0 * disparity / std::round(disparity / static_cast<double>(z)), 0.51);
  }
}

TEST(StereoNoise, HasAsManyHolesAsAsked) {
  StereoNoise noise = errorsOnly();
  EXPECT_EQ(shareOfZeros(stereoDepth(wall(1.5), kCamera, noise, 3)), 0.0);
  noise.hole_share = 0.04;
  const double share = shareOfZeros(stereoDepth(wall(1.5), kCamera, noise, 3));
  EXPECT_GT(share, 0.03);
  EXPECT_LT(share, 0.0405);
}

TEST(StereoNoise, HasAsManyOutliersAsAsked) {
  const DepthImage clean = wall(2.0);
  const auto far = [&clean](const StereoNoise& noise) {
    const Image<double> error = errorOf(stereoDepth(clean, kCamera, noise, 3), clean);
    const auto count =
        std::count_if(error.data.begin(), error.data.end(), [](double e) { return std::fabs(e) > 0.0198; });
    return static_cast<double>(count) / static_cast<double>(error.data.size());
  };
  EXPECT_LT(far(errorsOnly()), 0.001);  // 4.4 sigma
  StereoNoise noise = errorsOnly();
  noise.outlier_share = 0.03;
  EXPECT_GT(far(noise), 0.02);
  EXPECT_LT(far(noise), 0.031);
}

// A plate at 0.6 m, columns 200..299, rows 100..199, in front of a wall at 1.2 m.
DepthImage plateBeforeWall() {
  DepthImage depth = wall(1.2);
  for (int row = 100; row < 200; ++row)
    for (int column = 200; column < 300; ++column) depth.at(row, column) = 0.6F;
  return depth;
}

TEST(StereoNoise, LeavesAShadowLeftOfTheForeground) {
  StereoNoise noise = errorsOnly();
  noise.shadows = true;
  noise.edge_wobble = 0.0;
  const DepthImage depth = stereoDepth(plateBeforeWall(), kCamera, noise, 1);
  const double width = kCamera.fx * noise.baseline * (1.0 / 0.6 - 1.0 / 1.2);  // 10 px
  double holes_left = 0.0, holes_right = 0.0;
  for (int row = 110; row < 190; ++row)
    for (int i = 0; i < 40; ++i) {
      holes_left += depth.at(row, 199 - i) > 0.0F ? 0.0 : 1.0;
      holes_right += depth.at(row, 300 + i) > 0.0F ? 0.0 : 1.0;
    }
  EXPECT_NEAR(holes_left / 80.0, width, 1.0);
  EXPECT_EQ(holes_right, 0.0);
  // The second imager's view ends early: the wall's first disparity(1.2 m) = 10 columns are unseen.
  EXPECT_EQ(depth.at(20, 5), 0.0F);
  EXPECT_GT(depth.at(20, 12), 0.0F);
}

TEST(StereoNoise, SoftensEdges) {
  StereoNoise noise = errorsOnly();
  const auto between = [](const DepthImage& depth) {
    return std::count_if(depth.data.begin(), depth.data.end(), [](float z) { return z > 0.66F && z < 1.1F; });
  };
  EXPECT_GT(between(stereoDepth(plateBeforeWall(), kCamera, noise, 1)), 40);
  noise.flying_share = 0.0;
  EXPECT_EQ(between(stereoDepth(plateBeforeWall(), kCamera, noise, 1)), 0);
  // Wobble alone moves the edge by a pixel or two, and nothing far from it.
  const DepthImage depth = stereoDepth(plateBeforeWall(), kCamera, noise, 1);
  int moved = 0;
  for (int row = 0; row < depth.height; ++row)
    for (int column = 0; column < depth.width; ++column) {
      const bool plate = row >= 100 && row < 200 && column >= 200 && column < 300;
      if ((depth.at(row, column) < 0.8F) == plate) continue;
      ++moved;
      ASSERT_LE(std::min(std::min(std::abs(row - 100), std::abs(row - 199)),
                         std::min(std::abs(column - 200), std::abs(column - 299))),
                5);
    }
  EXPECT_GT(moved, 50);
}

TEST(StereoNoise, KeepsHolesOfTheInput) {
  DepthImage clean = wall(1.0);
  for (int column = 100; column < 140; ++column) clean.at(50, column) = 0.0F;
  const DepthImage depth = stereoDepth(clean, kCamera, errorsOnly(), 1);
  for (int column = 100; column < 140; ++column) ASSERT_EQ(depth.at(50, column), 0.0F);
}

TEST(NoiseField, HasUnitVarianceAndItsLength) {
  SceneRandom random(1, 2);
  const Image<float> field = noiseField(600, 500, 4.0, random);
  ASSERT_EQ(field.width, 600);
  ASSERT_EQ(field.height, 500);
  Image<double> values(600, 500);
  std::copy(field.data.begin(), field.data.end(), values.data.begin());
  EXPECT_NEAR(meanProduct(values, 0, 0), 1.0, 0.06);
  EXPECT_NEAR(meanProduct(values, 0, 4), std::exp(-0.5), 0.06);
  EXPECT_NEAR(meanProduct(values, 8, 0), std::exp(-2.0), 0.06);
}

TEST(NoiseField, QuantileLeavesTheShareAbove) {
  Image<float> ramp(100, 1);
  std::iota(ramp.data.begin(), ramp.data.end(), 0.0F);
  EXPECT_EQ(upperQuantile(ramp, 0.05), 94.0F);
  EXPECT_TRUE(std::isinf(upperQuantile(ramp, 0.0)));
  EXPECT_LT(upperQuantile(ramp, 1.0), 0.0F);
}

}  // namespace
}  // namespace epcc
