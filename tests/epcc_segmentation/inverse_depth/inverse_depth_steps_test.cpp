// SPDX-License-Identifier: BSD-3-Clause
// The steps S2 and S5 of the inverse-depth mode and the moments, one by one.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "inverse_depth/boundary_refinement.h"
#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/plane_growing.h"
#include "tests/epcc_segmentation/inverse_depth/region_fixture.h"

namespace {

using epcc::GrownLine;
using epcc::InverseDepthImage;
using epcc::PlaneMoments;
using epcc::SensorModel;

using epcc::test::imageOf;
using epcc::test::kWhite;
using epcc::test::regionsOf;

/// q of the plane (a, b, c, d): w = q . (u, v, 1).
Eigen::Vector3d inverseDepthPlane(const Eigen::Vector4d& plane) {
  return -plane.head<3>() / plane(3);
}

// ---- image ----

TEST(InverseDepthImage, HoldsTheInverseDepthsAndTheRays) {
  const auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(40, 30));
  const auto image = imageOf(room);
  for (int row = 0; row < 30; ++row)
    for (int column = 0; column < 40; ++column) {
      const std::size_t pixel = static_cast<std::size_t>(row) * 40 + column;
      const Eigen::Vector3d expected((column - room.camera.cx) / room.camera.fx,
                                     (row - room.camera.cy) / room.camera.fy, 1.0);
      ASSERT_LT((image.ray(row, column) - expected).norm(), 1e-12);
      ASSERT_FLOAT_EQ(image.w[pixel], 1.0f / room.depth[pixel]);
      const double q_w = inverseDepthPlane(epcc::test::cornerPlanes()[room.labels[pixel] - 1]).dot(expected);
      ASSERT_NEAR(image.w[pixel], q_w, 1e-6);
    }
}

// A rectangle of a cloud, or one with empty rows and columns: its pixels are as wide as those of the whole cloud.
TEST(InverseDepthImage, RowsAndColumnsWithoutPointsDoNotChangeThePitch) {
  const auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(60, 50));
  std::vector<float> xyz;
  Eigen::Vector3d p;
  for (int row = 0; row < 50; ++row)
    for (int column = 0; column < 60; ++column) {
      ASSERT_TRUE(room.frame().point(row, column, p));
      for (int k = 0; k < 3; ++k) xyz.push_back(static_cast<float>(p(k)));
    }
  const auto whole = epcc::DepthFrame::fromPoints(xyz.data(), 3, 60, 50, epcc::Projection::Perspective);
  InverseDepthImage expected;
  expected.read(whole);
  const auto inside = [](int row, int column) {
    return row >= 20 && row < 30 && row != 25 && column >= 24 && column < 36 && column != 27 && column != 28;
  };
  std::vector<std::uint8_t> mask;
  for (int row = 0; row < 50; ++row)
    for (int column = 0; column < 60; ++column) mask.push_back(inside(row, column));
  InverseDepthImage masked;
  masked.read(whole.masked(mask.data()));
  EXPECT_NEAR(epcc::pixelPitch(masked.along), epcc::pixelPitch(expected.along), 1e-7);
  EXPECT_NEAR(epcc::pixelPitch(masked.across), epcc::pixelPitch(expected.across), 1e-7);
  EXPECT_NEAR(masked.placeVariance(), expected.placeVariance(), 1e-6 * expected.placeVariance());
  for (std::size_t i = 0; i < 60; ++i) EXPECT_NEAR(masked.across[i], expected.across[i], 1e-6) << i;
  for (std::size_t i = 0; i < 50; ++i) EXPECT_NEAR(masked.along[i], expected.along[i], 1e-6) << i;
}

TEST(InverseDepthImage, NoiseIsSigmaZOverZSquared) {
  for (const auto& sensor : {SensorModel::axial(0.003, 0.002), *SensorModel::preset("d435i")}) {
    const auto noise = epcc::InverseDepthNoise::of(sensor);
    for (const double z : {0.4, 1.0, 3.0, 8.0})
      EXPECT_NEAR(std::sqrt(noise.variance(1.0 / z)), sensor.sigmaInverseDepth(z), 1e-12);
  }
}

// A pixel is 0.005 wide and 0.01 high in ray coordinates: on a surface inclined by 45 degrees, seen at z = 3 m, the
// variance of the place is that of (3 m * 0.005)^2 / 12 and (3 m * 0.01)^2 / 12 in depth, on the mean.
TEST(InverseDepthImage, NoDepthIsBetterThanThePlaceInThePixel) {
  const epcc::PinholeCamera camera{40, 30, 200.0, 100.0, 19.5, 14.5};
  const std::vector<float> depth(40 * 30, 3.0f);
  const double place2 = 9.0 * (0.005 * 0.005 + 0.01 * 0.01) / 24.0;
  InverseDepthImage image;
  image.read(epcc::DepthFrame::fromDepth(depth.data(), camera));
  image.weigh(SensorModel::axial(0.001, 0.0));
  EXPECT_NEAR(image.noise.variance(1.0 / 3.0), place2 / 81.0, 1e-12);
  EXPECT_NEAR(image.weight[0], 81.0 / place2, 1.0);
  image.weigh(SensorModel::axial(0.01, 0.0));
  EXPECT_NEAR(image.noise.variance(1.0 / 3.0), 0.01 * 0.01 / 81.0, 1e-12);
}

// ---- moments ----

TEST(PlaneMoments, RunsAddUpToBruteForceSums) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(40, 30));
  epcc::test::addNoise(room, kWhite, 1);
  const auto image = imageOf(room);
  const auto map = regionsOf(image, room.labels, 3);
  for (std::int32_t label = 1; label <= 3; ++label) {
    PlaneMoments brute;
    for (int row = 0; row < 30; ++row)
      for (int column = 0; column < 40; ++column) {
        const std::size_t pixel = static_cast<std::size_t>(row) * 40 + column;
        if (room.labels[pixel] != label) continue;
        const double w = static_cast<double>(image.w[pixel]);
        ASSERT_NEAR(image.weight[pixel] * image.noise.variance(w), 1.0, 1e-6);
        brute.add(image.ray(row, column), w, 1.0 / image.weight[pixel]);
      }
    const auto& region = map.regions[static_cast<std::size_t>(label - 1)];
    ASSERT_GT(brute.n, 50.0);
    EXPECT_EQ(region.n, brute.n);
    EXPECT_LT((region.rays - brute.rays).norm(), 1e-9 * brute.rays.norm());
    EXPECT_LT((region.rays_w - brute.rays_w).norm(), 1e-9 * brute.rays_w.norm());
    EXPECT_NEAR(region.w_w, brute.w_w, 1e-9 * brute.w_w);
    EXPECT_NEAR(region.w_sum, brute.w_sum, 1e-9 * brute.w_sum);
  }
}

TEST(PlaneMoments, FitFindsThePlaneAndItsResiduals) {
  const Eigen::Vector3d q(0.2, -0.1, 0.5);
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  std::normal_distribution<double> normal(0.0, 0.01);
  PlaneMoments moments;
  for (int i = 0; i < 4000; ++i) {
    const Eigen::Vector3d ray(uniform(generator), uniform(generator), 1.0);
    moments.add(ray, q.dot(ray) + normal(generator), 1e-4);
  }
  const auto fit = moments.fit(0.0);
  EXPECT_LT((fit.q - q).norm(), 3e-3);
  EXPECT_NEAR(fit.rss / moments.n, 1.0, 0.1);
  // A strong ridge pulls the slopes to zero, not the height.
  const auto flat = moments.fit(1e12);
  EXPECT_LT(flat.q.head<2>().norm(), 1e-6);
  EXPECT_NEAR(flat.q.z(), 0.5, 0.05);
}

TEST(PlaneMoments, SlopeFactorGrowsWithTheAngleAndIsClipped) {
  EXPECT_NEAR(epcc::slopeFactor({0.0, 0.0, 1.0}, 1.0), 1.0, 1e-12);
  EXPECT_NEAR(epcc::slopeFactor({0.6, 0.8, 1.0}, 0.5), 5.0, 1e-12);
  EXPECT_NEAR(epcc::slopeFactor({100.0, 0.0, 1.0}, 0.5), 26.0, 1e-12);
}

// ---- S2 ----

/// The line of samples of the given weights.
GrownLine lineOf(int first, const std::vector<double>& x, const std::vector<double>& w,
                 const std::vector<double>& weight) {
  double sum = 0.0, mean_x = 0.0, mean_w = 0.0, sxx = 0.0, sxw = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += weight[i];
    mean_x += weight[i] * x[i];
    mean_w += weight[i] * w[i];
  }
  mean_x /= sum;
  mean_w /= sum;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += weight[i] * (x[i] - mean_x) * (x[i] - mean_x);
    sxw += weight[i] * (x[i] - mean_x) * (w[i] - mean_w);
  }
  GrownLine line;
  line.first = first;
  line.n = static_cast<int>(x.size());
  line.last = first + line.n - 1;
  line.weight = static_cast<float>(sum);
  line.mean_x = static_cast<float>(mean_x);
  line.mean_w = static_cast<float>(mean_w);
  line.sxx = static_cast<float>(sxx);
  line.sxw = static_cast<float>(sxw);
  return line;
}

TEST(PlaneGrowing, PlanesFitTheSamplesOfTheirSegments) {
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> uniform(0.2, 1.0);
  PlaneMoments brute;
  epcc::GrownPlane plane;
  plane.ridge = 3.0;
  for (const double side : {0.3, -0.2, 0.1}) {
    const double forward = std::sqrt(1.0 - side * side);  // as in a spherical scan
    std::vector<double> x, w, weight;
    for (int i = 0; i < 50; ++i) {
      x.push_back(0.01 * i);
      w.push_back(uniform(generator));
      weight.push_back(uniform(generator));
      brute.add(Eigen::Vector3d(side, x.back(), forward), w.back(), 1.0 / weight.back());
    }
    plane.moments.add({side, forward}, lineOf(0, x, w, weight));
  }
  EXPECT_EQ(plane.moments.n, brute.n);
  plane.fit();
  const auto expected = brute.fit(plane.ridge);
  const epcc::SymmetricMatrix& m = plane.inverse;
  Eigen::Matrix3d inverse;
  inverse << m.ss, m.sx, m.sf, m.sx, m.xx, m.xf, m.sf, m.xf, m.ff;
  EXPECT_LT((inverse - expected.inverse).norm(), 1e-5 * expected.inverse.norm());
  EXPECT_LT((Eigen::Vector3d(plane.q_side, plane.q_x, plane.q_forward) - expected.q).norm(), 1e-5 * expected.q.norm());
}

GrownLine lineOf(double w, int first, int last, double sigma_w) {
  const auto count = static_cast<std::size_t>(last - first + 1);
  std::vector<double> x;
  for (int i = first; i <= last; ++i) x.push_back(0.005 * i);
  return lineOf(first, x, std::vector<double>(count, w), std::vector<double>(count, 1.0 / (sigma_w * sigma_w)));
}

std::vector<int> planesOf(const std::vector<std::vector<GrownLine>>& scan_lines) {
  epcc::PlaneGrowing growing(epcc::InverseDepthParameters(), kWhite);
  growing.begin(0.005, false);
  for (std::size_t i = 0; i < scan_lines.size(); ++i)
    growing.addLine({0.005 * static_cast<double>(i), 1.0}, scan_lines[i].data(),
                    static_cast<int>(scan_lines[i].size()));
  return growing.planeOf();
}

TEST(PlaneGrowing, NeighboursOfOneHeightJoinAndAStepDoesNot) {
  std::vector<std::vector<GrownLine>> lines;
  for (int i = 0; i < 20; ++i) lines.push_back({lineOf(i < 10 ? 0.5 : 0.52, 0, 50, 5e-4)});
  const auto planes = planesOf(lines);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(planes[static_cast<std::size_t>(i)], i < 10 ? 0 : 1) << i;
}

TEST(PlaneGrowing, ALineWithoutASegmentDoesNotEndASurface) {
  EXPECT_EQ(planesOf({{lineOf(0.5, 0, 50, 5e-4)}, {}, {lineOf(0.5, 0, 50, 5e-4)}}), (std::vector<int>{0, 0}));
}

TEST(PlaneGrowing, SegmentsThatDoNotOverlapInTheImageStayApart) {
  EXPECT_EQ(planesOf({{lineOf(0.5, 0, 50, 5e-4)}, {lineOf(0.5, 60, 100, 5e-4)}})[1], 1);
  EXPECT_EQ(planesOf({{lineOf(0.5, 0, 50, 5e-4)}, {lineOf(0.5, 49, 100, 5e-4)}})[1], 1);  // 2 pixels
  EXPECT_EQ(planesOf({{lineOf(0.5, 0, 50, 5e-4)}, {lineOf(0.5, 20, 80, 5e-4)}})[1], 0);
}

// ---- S5 ----

TEST(BoundaryRefinement, AShiftedCornerMovesBackAndHolesAreFilled) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  epcc::test::addNoise(room, kWhite, 5);
  const auto image = imageOf(room);
  auto labels = room.labels;
  for (int row = 0; row < 120; ++row)  // every border moves three pixels to the right
    for (int column = 159; column >= 3; --column)
      labels[static_cast<std::size_t>(row) * 160 + column] =
          room.labels[static_cast<std::size_t>(row) * 160 + column - 3];
  for (std::size_t i = 0; i < labels.size(); i += 11) labels[i] = 0;
  const auto wrong = [&](const std::vector<std::int32_t>& now) {
    long count = 0;
    for (std::size_t i = 0; i < now.size(); ++i) count += now[i] != room.labels[i] ? 1 : 0;
    return count;
  };
  const long before = wrong(labels);
  auto map = regionsOf(image, room.labels, 3);  // the planes are known, the borders are not
  map.labels = labels;
  epcc::RefinementMemory memory;
  epcc::refineBoundaries(image, epcc::InverseDepthParameters(), map, memory);
  EXPECT_GT(before, 1500);
  EXPECT_LT(wrong(map.labels), before / 20);
}

TEST(BoundaryRefinement, NothingIsLabelledBeyondTheResidual) {
  auto room = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(60, 40));
  for (int column = 20; column < 30; ++column) room.depth[static_cast<std::size_t>(20 * 60 + column)] -= 0.5f;
  const auto image = imageOf(room);
  auto labels = room.labels;
  for (int column = 20; column < 30; ++column) labels[static_cast<std::size_t>(20 * 60 + column)] = 0;
  auto map = regionsOf(image, labels, 1);
  epcc::RefinementMemory memory;
  epcc::refineBoundaries(image, epcc::InverseDepthParameters(), map, memory);
  EXPECT_EQ(map.labels, labels);
}

}  // namespace
