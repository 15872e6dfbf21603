// SPDX-License-Identifier: BSD-3-Clause
// On every vector unit the kernels give the bits of a plain loop.
#include "sensor/block_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "epcc_segmentation/vector_unit.h"

namespace epcc {
namespace {

enum class Kind { Noisy, Holes, Constant, Step };

/// A gathered block, tilted, of the kind; centred as blocks are.
BlockSamples blockOf(Kind kind, int side, unsigned seed, const BlockRays& rays) {
  std::mt19937 generator(seed);
  std::normal_distribution<float> normal;
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  std::vector<float> w(static_cast<std::size_t>(side) * side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      float& value = w[static_cast<std::size_t>(y * side + x)];
      value = 0.5f;
      if (kind == Kind::Constant) continue;
      value += 0.001f * static_cast<float>(x) - 0.002f * static_cast<float>(y) + 0.001f * normal(generator);
      if (kind == Kind::Step && x > side / 2) value += 0.2f;
      if (kind == Kind::Holes && uniform(generator) < 0.15f) value = 0.0f;
    }
  BlockSamples samples;
  gatherBlock(w.data(), static_cast<std::size_t>(side), side, samples);
  subtractCentre(0.5f, rays, samples);
  return samples;
}

/// Those of a scan with uneven rings.
BlockRays raysOf(int side) {
  BlockRays rays = {};
  for (int i = 0; i < side; ++i) {
    const float t = (2.0f * static_cast<float>(i) - static_cast<float>(side - 1)) / static_cast<float>(side - 1);
    rays.x[i] = t;
    rays.forward[i] = 1.0f - 0.02f * t * t;
    rays.y[i] = t + 0.1f * t * t - 0.1f;
  }
  return rays;
}

const SamplePlane kPlane = {0.013f, -0.03f, 0.003f};
constexpr float kGate = 0.0081f;

float residual(const BlockSamples& samples, const BlockRays& rays, const SamplePlane& plane, int x, int y) {
  const float along_columns = plane.x * rays.x[x] + plane.forward * rays.forward[x];
  return samples.w[y * samples.pitch + x] - (along_columns + plane.y * rays.y[y]);
}

void expectSameBits(const float* found, const float* expected, int count, const std::string& what) {
  EXPECT_EQ(std::memcmp(found, expected, static_cast<std::size_t>(count) * sizeof(float)), 0) << what;
}

/// Runs the check on every unit and every kind and size of block.
class BlockKernels : public ::testing::Test {
 protected:
  ~BlockKernels() override { setVectorUnit(before_); }

  template <typename Check>
  void onEveryUnit(const Check& check) {
    for (const std::string& unit : vectorUnits()) {
      ASSERT_TRUE(setVectorUnit(unit));
      for (const Kind kind : {Kind::Noisy, Kind::Holes, Kind::Constant, Kind::Step})
        for (const int side : {4, 8, 11, 15, 16, 17, 24, 31, 32})
          check(blockOf(kind, side, 7, raysOf(side)), raysOf(side),
                unit + ", kind " + std::to_string(static_cast<int>(kind)) + ", side " + std::to_string(side));
    }
  }

 private:
  std::string before_ = vectorUnit();
};

TEST_F(BlockKernels, ABlockIsGatheredWithItsHolesAndThinnedToAQuarter) {
  std::mt19937 generator(8);
  const auto all = std::make_unique<BlockSamples>(), quarter = std::make_unique<BlockSamples>();
  for (const std::string& unit : vectorUnits()) {
    ASSERT_TRUE(setVectorUnit(unit));
    for (const int side : {8, 11, 16, 17, 24, 31, 32})
      for (const int holes : {0, 7}) {
        std::vector<float> image(static_cast<std::size_t>(side) * (side + 3) - 3);  // ends with the block
        for (float& w : image)
          w = holes > 0 && generator() % holes == 0 ? 0.0f : 0.25f + static_cast<float>(generator() % 64) / 128.0f;
        gatherBlock(image.data(), static_cast<std::size_t>(side) + 3, side, *all);
        gatherQuarter(*all, *quarter);
        const std::string what = unit + ", side " + std::to_string(side) + ", holes " + std::to_string(holes);
        int valid = 0, valid_of_quarter = 0;
        for (int y = 0; y < side; ++y)
          for (int x = 0; x < all->pitch; ++x) {
            const float w = x < side ? image[static_cast<std::size_t>(y * (side + 3) + x)] : 0.0f;
            const float expected = w > 0.0f ? w : kNowhere;
            EXPECT_EQ(all->w[y * all->pitch + x], expected) << what;
            valid += w > 0.0f ? 1 : 0;
            if (x % 2 != 0 || y % 2 != 0 || x / 2 >= side / 2 || y / 2 >= side / 2) continue;
            EXPECT_EQ(quarter->w[y / 2 * quarter->pitch + x / 2], expected) << what;
            valid_of_quarter += w > 0.0f ? 1 : 0;
          }
        EXPECT_EQ(all->valid, valid) << what;
        EXPECT_EQ(quarter->valid, valid_of_quarter) << what;
        for (int i = 0; i < kRowOfVector; ++i) EXPECT_EQ(all->w[side * all->pitch + i], kNowhere) << what;
        const BlockRays rays = raysOf(side);
        subtractCentre(0.25f, rays, *all);
        for (int x = 0; x < side; ++x)
          EXPECT_EQ(all->w[x],
                    (image[static_cast<std::size_t>(x)] > 0.0f ? image[static_cast<std::size_t>(x)] : kNowhere) -
                        0.25f * rays.forward[x])
              << what;
      }
  }
}

TEST_F(BlockKernels, SumsOverTheInliersAreThoseOfALoop) {
  onEveryUnit([](const BlockSamples& samples, const BlockRays& rays, const std::string& what) {
    ColumnSums found;
    sumInliers(samples, rays, kPlane, kGate, found);
    ColumnSums expected{};
    for (int x = 0; x < samples.side; ++x)
      for (int y = 0; y < samples.side; ++y) {
        const float e = residual(samples, rays, kPlane, x, y);
        const float t = rays.y[y];
        if (!(std::abs(e) <= kGate)) continue;
        expected.n[x] += 1.0f;
        expected.y[x] += t;
        expected.yy[x] += t * t;
        expected.e[x] += e;
        expected.ey[x] += e * t;
      }
    expectSameBits(found.n, expected.n, samples.side, what);
    expectSameBits(found.y, expected.y, samples.side, what);
    expectSameBits(found.yy, expected.yy, samples.side, what);
    expectSameBits(found.e, expected.e, samples.side, what);
    expectSameBits(found.ey, expected.ey, samples.side, what);
  });
}

TEST_F(BlockKernels, ResidualOfARankIsTheOrderedOneToHalfAPercent) {
  onEveryUnit([](const BlockSamples& samples, const BlockRays& rays, const std::string& what) {
    std::vector<float> sizes;
    for (int x = 0; x < samples.side; ++x)
      for (int y = 0; y < samples.side; ++y) sizes.push_back(std::abs(residual(samples, rays, kPlane, x, y)));
    std::sort(sizes.begin(), sizes.end());
    constexpr float kLargest = 0.5f;
    for (const double share : {0.0, 0.3, 0.68, 0.8}) {
      const auto rank = static_cast<int>(share * (samples.valid - 1));
      float expected = kLargest;  // a loop that counts
      float half = 1.0f / 4096.0f;
      for (int step = 0; step < 12; ++step, half = std::sqrt(half)) {
        const auto below = std::upper_bound(sizes.begin(), sizes.end(), expected * half) - sizes.begin();
        if (below > rank) expected *= half;
      }
      const float found = residualOfRank(samples, rays, kPlane, rank, kLargest);
      EXPECT_EQ(found, expected) << what;
      const float ordered = sizes[static_cast<std::size_t>(rank)];
      EXPECT_GE(found, ordered * 0.99999f) << what;
      EXPECT_LE(found, std::max(ordered * 1.005f, kLargest * 6.1e-8f)) << what;
    }
    EXPECT_EQ(residualOfRank(samples, rays, {0.0f, 0.0f, 20.0f}, samples.valid / 2, kLargest), kLargest) << what;
  });
}

TEST_F(BlockKernels, TheSmallestStepIsThatOfQuantisedValues) {
  constexpr int kSide = 17;  // the last column has a vector of its own
  const auto samples = std::make_unique<BlockSamples>();
  for (const std::string& unit : vectorUnits()) {
    ASSERT_TRUE(setVectorUnit(unit));
    std::vector<float> w(kSide * kSide, 1.0f);
    const auto step = [&] {
      gatherBlock(w.data(), kSide, kSide, *samples);
      return smallestStep(*samples);
    };
    EXPECT_EQ(step(), 0.0f) << unit;
    w[5 * kSide + 4] = std::nextafter(1.0f, 2.0f);  // rounding
    w[7 * kSide + 3] = 0.0f;                        // a hole
    EXPECT_EQ(step(), 0.0f) << unit;
    for (int i = 0; i < kSide * kSide; ++i) w[static_cast<std::size_t>(i)] += 0.125f * static_cast<float>(i % 7 / 3);
    EXPECT_NEAR(step(), 0.125f, 1e-6f) << unit;
    w.back() += 0.0625f;  // the last of all is the nearest
    EXPECT_NEAR(step(), 0.0625f, 1e-6f) << unit;
  }
}

TEST_F(BlockKernels, NoStepIsSeenWhereNoTwoSamplesAreBesideEachOther) {
  const auto samples = std::make_unique<BlockSamples>();
  std::vector<float> w(256, 0.0f);
  for (std::size_t i = 0; i < w.size(); i += 3) w[i] = 0.5f + 0.001f * static_cast<float>(i);
  gatherBlock(w.data(), 16, 16, *samples);
  EXPECT_EQ(smallestStep(*samples), 0.0f);
}

}  // namespace
}  // namespace epcc
