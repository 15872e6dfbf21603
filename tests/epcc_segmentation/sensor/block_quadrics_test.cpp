// SPDX-License-Identifier: BSD-3-Clause
// Sums of parts, shifted and joined, leave what a fit to the pixels themselves leaves.
#include "sensor/block_quadrics.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "epcc_segmentation/vector_unit.h"

namespace epcc {
namespace {

BlockRays raysOf(int side, bool uneven) {
  BlockRays rays = {};
  for (int i = 0; i < side; ++i) {
    const float t = (2.0f * static_cast<float>(i) - static_cast<float>(side - 1)) / static_cast<float>(side - 1);
    rays.x[i] = t;
    rays.forward[i] = uneven ? 1.0f - 0.02f * t * t : 1.0f;
    rays.y[i] = uneven ? t + 0.15f * t * t * t - 0.1f * t * t : t;
  }
  return rays;
}

const SamplePlane kStartPlane = {0.013f, -0.03f, 0.003f};
constexpr float kQuadricGate = 0.004f;

/// Curved, with an error, and with holes and outliers at one side.
BlockSamples blockOf(int side, const BlockRays& rays, double bad, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<float> normal(0.0f, 0.001f);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<float> w;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const float quadric = 0.001f * rays.x[x] * rays.x[x] - 0.0007f * rays.x[x] * rays.y[y];
      w.push_back(0.5f + 0.013f * rays.x[x] - 0.03f * rays.y[y] + quadric + normal(generator));
      if (uniform(generator) < bad * (1.0 + static_cast<double>(rays.x[x]))) w.back() = x % 2 == 0 ? 0.0f : 0.9f;
    }
  BlockSamples samples;
  gatherBlock(w.data(), static_cast<std::size_t>(side), side, samples);
  subtractCentre(0.497f, rays, samples);
  return samples;
}

/// The definition: the pixels' equations by QR, in double precision.
QuadricResiduals ofPixels(const BlockSamples& samples, const BlockRays& rays) {
  QuadricResiduals result;
  for (int scale = 0; scale < kScales; ++scale) {
    const int across = 4 >> scale, side = samples.side / across;
    double squares = 0.0, pixels = 0.0;
    result.inliers = 0.0;
    for (int part = 0; part < across * across; ++part) {
      std::vector<Eigen::Matrix<double, 6, 1>> rows;
      std::vector<double> errors;
      for (int i = 0; i < side * side; ++i) {
        const int column = part % across * side + i % side, row = part / across * side + i / side;
        const float said =
            kStartPlane.x * rays.x[column] + kStartPlane.forward * rays.forward[column] + kStartPlane.y * rays.y[row];
        const double e = static_cast<double>(samples.w[row * samples.pitch + column] - said);
        if (std::abs(e) > static_cast<double>(kQuadricGate)) continue;
        const auto x = static_cast<double>(rays.x[column]), y = static_cast<double>(rays.y[row]);
        rows.emplace_back();
        rows.back() << 1.0, x, y, x * x, x * y, y * y;
        errors.push_back(e);
      }
      const auto n = static_cast<double>(rows.size());
      result.inliers += n;
      Eigen::MatrixXd a(rows.size(), 6);
      for (std::size_t i = 0; i < rows.size(); ++i) a.row(static_cast<long>(i)) = rows[i];
      const Eigen::Map<const Eigen::VectorXd> b(errors.data(), static_cast<long>(errors.size()));
      const double left = (b - a * a.householderQr().solve(b)).squaredNorm();
      const Eigen::MatrixXd plane = a.leftCols(3);
      result.bent = ((b - plane * plane.householderQr().solve(b)).squaredNorm() - left) / 3.0 / (left / (n - 6.0));
      if (n < 0.6 * side * side || n < 12.0) continue;
      squares += left;
      pixels += n;
    }
    if (pixels > 0.0) result.squares[static_cast<std::size_t>(scale)] = squares / pixels;
  }
  return result;
}

TEST(BlockQuadrics, AreThoseOfThePixelsWithTheSameBitsOnEveryUnit) {
  const std::string before = vectorUnit();
  for (const int side : {16, 32})
    for (const bool uneven : {false, true})
      for (const double bad : {0.0, 0.02, 0.15, 0.35}) {
        const std::string what = std::to_string(side) + ", " + std::to_string(uneven) + ", " + std::to_string(bad);
        const BlockRays rays = raysOf(side, uneven);
        const auto samples = std::make_unique<BlockSamples>(blockOf(side, rays, bad, 3));
        const QuadricResiduals expected = ofPixels(*samples, rays);
        QuadricResiduals first;
        for (const std::string& unit : vectorUnits()) {
          ASSERT_TRUE(setVectorUnit(unit));
          const QuadricResiduals found = fitQuadrics(*samples, rays, kStartPlane, kQuadricGate);
          EXPECT_EQ(found.inliers, expected.inliers) << what << ", " << unit;
          for (std::size_t scale = 0; scale < kScales; ++scale) {
            const double size = expected.squares[scale];
            EXPECT_NEAR(found.squares[scale], size, 2e-5 * size) << what << ", " << unit << ", " << scale;
          }
          if (unit == vectorUnits().front()) first = found;
          EXPECT_EQ(found.squares, first.squares) << what << ", " << unit;
          EXPECT_NEAR(found.bent, expected.bent, 1e-3 * (1.0 + expected.bent)) << what << ", " << unit;
          EXPECT_EQ(found.bent, first.bent) << what << ", " << unit;
        }
      }
  setVectorUnit(before);
}

TEST(BlockQuadrics, OfWhiteErrorOnPlanesATenthBendLessThanChanceSays) {
  const BlockRays rays = raysOf(32, false);
  std::mt19937 generator(5);
  std::normal_distribution<float> normal(0.0f, 0.001f);
  std::vector<float> w(32 * 32);
  BlockSamples samples;
  constexpr int kTries = 600;
  int low = 0;
  double sum = 0.0;
  for (int i = 0; i < kTries; ++i) {
    for (float& value : w) value = 0.5f + normal(generator);
    gatherBlock(w.data(), 32, 32, samples);
    subtractCentre(0.5f, rays, samples);
    const double bent = fitQuadrics(samples, rays, {}, 0.004f).bent;
    low += bent < 0.195 ? 1 : 0;  // chi square of three degrees of freedom
    sum += bent;
  }
  EXPECT_NEAR(low, 0.1 * kTries, 3.0 * std::sqrt(0.09 * kTries));
  EXPECT_NEAR(sum / kTries, 1.0, 0.1);
}

TEST(BlockQuadrics, APartThatIsMostlyHolesIsNotCounted) {
  const BlockRays rays = raysOf(16, false);
  auto samples = std::make_unique<BlockSamples>(blockOf(16, rays, 0.0, 4));
  const QuadricResiduals whole = fitQuadrics(*samples, rays, kStartPlane, kQuadricGate);
  for (int y = 0; y < 16; ++y)  // in each part of 4 x 4 pixels, 11 stay, fewer than 12
    for (int x = 0; x < 16; ++x)
      if (x % 4 + 4 * (y % 4) < 5) samples->w[y * samples->pitch + x] = kNowhere;
  const QuadricResiduals holed = fitQuadrics(*samples, rays, kStartPlane, kQuadricGate);
  EXPECT_GT(whole.squares[0], 0.0);
  EXPECT_EQ(holed.squares[0], 0.0);
  EXPECT_NEAR(holed.squares[2] / whole.squares[2], 1.0, 0.2);
}

}  // namespace
}  // namespace epcc
