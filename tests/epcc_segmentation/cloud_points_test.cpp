// SPDX-License-Identifier: BSD-3-Clause
// Parts of clouds are read in vectors: the same points as one by one, on every vector unit.
#include "cloud_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/support/vector_units.h"

namespace epcc {
namespace {

constexpr int kCloudWidth = 37, kCloudHeight = 21;
constexpr float kNear = 50.0f;  // the farthest coordinate of scan points

/// Random points with one odd value in nine; nothing lies behind the last point's z.
std::vector<float> randomPoints(std::size_t stride) {
  const float odd[] = {0.0f,
                       -0.0f,
                       1e-42f,
                       3e38f,
                       -60.0f,
                       kNear,
                       std::numeric_limits<float>::infinity(),
                       std::numeric_limits<float>::quiet_NaN()};
  std::mt19937 random(3);
  std::vector<float> points(stride * kCloudWidth * kCloudHeight - (stride - 3));
  for (float& value : points)
    value = random() % 9 == 0 ? odd[random() % 8] : static_cast<float>(random() % 2001) * 0.01f - 10.0f;
  for (std::size_t i = 0; i < 40; ++i) points[i] = 0.0f;  // the sensor itself
  return points;
}

struct Coordinates {
  std::vector<float> x, y, z;

  explicit Coordinates(std::size_t size) : x(size, 0.0f), y(x), z(x) {}
  void set(std::size_t i, const Eigen::Vector3d& p) {
    x[i] = static_cast<float>(p.x());
    y[i] = static_cast<float>(p.y());
    z[i] = static_cast<float>(p.z());
  }
};

void expectTheSame(const DepthFrame& cloud, const CloudPart& part) {
  const std::size_t pitch = static_cast<std::size_t>(part.columns) + 3;
  Coordinates own(pitch * static_cast<std::size_t>(part.rows)), scan(own);
  Eigen::Vector3d p;
  for (int row = 0; row < part.rows; ++row)
    for (int i = 0; i < part.columns; ++i) {
      const std::size_t at = static_cast<std::size_t>(row) * pitch + static_cast<std::size_t>(i);
      const int column = part.column + i * part.step;
      if (cloud.point(part.row + row, column, p)) own.set(at, p);
      if (cloud.scanPoint(part.row + row, column, p) && p.cwiseAbs().maxCoeff() <= static_cast<double>(kNear))
        scan.set(at, p);
    }
  test::onEveryVectorUnit([&] {
    Coordinates points(own.x.size());
    readPoints(cloud, part, {points.x.data(), points.y.data(), points.z.data(), pitch});
    EXPECT_EQ(points.x, own.x);
    EXPECT_EQ(points.y, own.y);
    EXPECT_EQ(points.z, own.z);
    readScanPoints(cloud, part, kNear, {points.x.data(), points.y.data(), points.z.data(), pitch});
    EXPECT_EQ(points.x, scan.x);
    EXPECT_EQ(points.y, scan.y);
    EXPECT_EQ(points.z, scan.z);
  });
}

TEST(CloudPoints, AreThoseOfTheFrameOneByOne) {
  std::vector<std::uint8_t> mask(kCloudWidth * kCloudHeight);
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = i % 5 == 0 ? 0 : 1;
  for (const std::size_t stride : {3, 4, 8})
    for (const Projection projection :
         {Projection::Perspective, Projection::PerspectiveBackward, Projection::Spherical}) {
      const std::vector<float> points = randomPoints(stride);
      const DepthFrame cloud = DepthFrame::fromPoints(points.data(), stride, kCloudWidth, kCloudHeight, projection);
      for (const DepthFrame& view :
           {cloud, cloud.transposed(), cloud.masked(mask.data()), cloud.masked(mask.data()).transposed()}) {
        SCOPED_TRACE(testing::Message() << "stride " << stride << ", projection " << static_cast<int>(projection));
        const int last_row = view.height() - 1, last_column = view.width() - 1;
        expectTheSame(view, {0, view.height(), 0, view.width(), 1});
        expectTheSame(view, {last_row, 1, 1, view.width() / 2, 2});
        expectTheSame(view, {2, 5, 3, 16, 1});
        expectTheSame(view, {last_row, 1, last_column, 1, 1});
      }
    }
}

}  // namespace
}  // namespace epcc
