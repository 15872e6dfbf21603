// SPDX-License-Identifier: BSD-3-Clause
// Clouds of a camera are read in vectors: the same bits as point by point, on every vector unit.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "epcc_segmentation/vector_unit.h"
#include "inverse_depth/depth_inversion.h"
#include "inverse_depth/perspective_points.h"

namespace epcc {
namespace {

struct Sums {
  std::vector<float> w;
  std::vector<double> across, column_count, along, row_count;

  explicit Sums(const DepthFrame& frame)
      : w(static_cast<std::size_t>(frame.width() * frame.height()), -1.0f),
        across(static_cast<std::size_t>(frame.width()), 0.0),
        column_count(across),
        along(static_cast<std::size_t>(frame.height()), 0.0),
        row_count(along) {}
};

/// One point after the other.
Sums expectedSums(const DepthFrame& frame) {
  Sums sums(frame);
  Eigen::Vector3d p;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) {
      const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
      float& w = sums.w[r * static_cast<std::size_t>(frame.width()) + c];
      w = 0.0f;
      if (!frame.scanPoint(row, column, p)) continue;
      if (p.cwiseAbs().maxCoeff() > static_cast<double>(kFarthestMeasured)) continue;
      const double inverse = 1.0 / p.z();
      if (static_cast<float>(inverse) > kLargestInverse) continue;
      w = static_cast<float>(inverse);
      sums.across[c] += p.x() * inverse;
      sums.along[r] += p.y() * inverse;
      sums.column_count[c] += 1.0;
      sums.row_count[r] += 1.0;
    }
  return sums;
}

void expectTheSame(const DepthFrame& frame, const std::string& what) {
  const Sums expected = expectedSums(frame);
  PerspectivePoints points;
  for (const std::string& unit : vectorUnits()) {
    ASSERT_TRUE(setVectorUnit(unit));
    Sums sums(frame);
    points.read(frame, static_cast<std::size_t>(frame.width()), sums.w.data(), sums.across.data(),
                sums.column_count.data(), sums.along.data(), sums.row_count.data());
    EXPECT_EQ(sums.w, expected.w) << what << ", " << unit;
    EXPECT_EQ(sums.across, expected.across) << what << ", " << unit;
    EXPECT_EQ(sums.along, expected.along) << what << ", " << unit;
    EXPECT_EQ(sums.column_count, expected.column_count) << what << ", " << unit;
    EXPECT_EQ(sums.row_count, expected.row_count) << what << ", " << unit;
  }
}

class PerspectivePointsTest : public ::testing::Test {
 protected:
  PerspectivePointsTest() : unit_(vectorUnit()) {}
  ~PerspectivePointsTest() override { setVectorUnit(unit_); }

 private:
  std::string unit_;
};

/// Random points with one odd value in ten; nothing lies behind the last point's z.
std::vector<float> randomPoints(std::size_t stride, int width, int height) {
  const float odd[] = {0.0f,
                       -1.0f,
                       1e-42f,
                       3e38f,
                       -0.0f,
                       std::numeric_limits<float>::quiet_NaN(),
                       std::numeric_limits<float>::infinity(),
                       -std::numeric_limits<float>::infinity()};
  std::mt19937 random(static_cast<unsigned>(stride));
  std::uniform_real_distribution<float> coordinate(-2.0f, 4.0f);
  std::vector<float> xyz(stride * static_cast<std::size_t>(width * height - 1) + 3);
  for (float& value : xyz) value = random() % 10 == 0 ? odd[random() % 8] : coordinate(random);
  return xyz;
}

TEST_F(PerspectivePointsTest, HaveTheSameBitsAsPointByPoint) {
  for (const std::size_t stride : {3, 4, 8, 12})
    for (const int width : {1, 2, 15, 16, 17, 53})
      for (const int height : {1, 4, 7}) {
        const std::vector<float> xyz = randomPoints(stride, width, height);
        std::vector<std::uint8_t> mask(static_cast<std::size_t>(width * height));
        for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = i % 3 != 0;
        for (const Projection projection : {Projection::Perspective, Projection::PerspectiveBackward}) {
          const DepthFrame frame = DepthFrame::fromPoints(xyz.data(), stride, width, height, projection);
          const std::string what = std::to_string(width) + "x" + std::to_string(height) + ", stride " +
                                   std::to_string(stride) + (projection == Projection::Perspective ? "" : ", backward");
          expectTheSame(frame, what);
          expectTheSame(frame.masked(mask.data()), what + ", masked");
          expectTheSame(frame.transposed(), what + ", transposed");
          expectTheSame(frame.masked(mask.data()).transposed(), what + ", masked, transposed");
        }
      }
}

}  // namespace
}  // namespace epcc
