// SPDX-License-Identifier: BSD-3-Clause
// Least-squares planes: exact data, order, and a covariance that predicts the scatter of repeated fits.
#include "epcc_segmentation/plane_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "inverse_depth/inverse_depth_image.h"
#include "plane_fit_samples.h"
#include "tests/support/rendered_room.h"
#include "tests/support/vector_units.h"

namespace {

using epcc::DepthFrame;
using epcc::PlaneSegmentation;
using epcc::SensorModel;

PlaneSegmentation fitted(const epcc::test::RenderedRoom& room, const SensorModel& sensor, int planes) {
  PlaneSegmentation segmentation;
  segmentation.width = room.camera.width;
  segmentation.height = room.camera.height;
  segmentation.labels = room.labels;
  epcc::fitPlanes(room.frame(), sensor, planes, segmentation);
  return segmentation;
}

TEST(PlaneFit, ExactRoomGivesItsPlanesSortedBySize) {
  const auto planes = epcc::test::cornerPlanes();
  const auto room = epcc::test::renderRoom(planes, epcc::test::testCamera());
  const auto result = fitted(room, SensorModel::preset("rendered").value(), 3);
  ASSERT_EQ(result.planes.size(), 3u);
  for (std::size_t i = 0; i < result.labels.size(); ++i) {
    const auto& plane = result.planes[static_cast<std::size_t>(result.labels[i] - 1)];
    const auto& truth = planes[static_cast<std::size_t>(room.labels[i] - 1)];
    ASSERT_LT((plane.coefficients - truth).norm(), 1e-5);
    ASSERT_GT(plane.coefficients(3), 0.0);
    ASSERT_NEAR(plane.coefficients.head<3>().norm(), 1.0, 1e-12);
    ASSERT_LT(plane.rms, 1e-6);
  }
  for (std::size_t k = 1; k < 3; ++k) EXPECT_GE(result.planes[k - 1].pixel_count, result.planes[k].pixel_count);
}

TEST(PlaneFit, LabelsWithoutPixelsDisappear) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  for (auto& label : room.labels) label *= 3;  // ids 3, 6, 9 of nine
  const auto result = fitted(room, *SensorModel::preset("d435i"), 9);
  EXPECT_EQ(result.planes.size(), 3u);
  EXPECT_EQ(*std::max_element(result.labels.begin(), result.labels.end()), 3);
}

TEST(PlaneFit, OtherLabelsThanThePlanesCountAsNone) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  const auto usual = fitted(room, *SensorModel::preset("d435i"), 3);
  for (std::size_t i = 0; i < room.labels.size(); ++i)
    if (usual.labels[i] == 3) room.labels[i] = i % 2 == 0 ? 4 : -7;
  room.labels.front() = std::numeric_limits<std::int32_t>::max();
  room.labels.back() = std::numeric_limits<std::int32_t>::min();
  const auto frame = room.frame();
  for (const auto& view : {frame, frame.transposed()}) {
    PlaneSegmentation segmentation;
    segmentation.labels = room.labels;
    EXPECT_TRUE(epcc::fitPlanes(view, *SensorModel::preset("d435i"), 3, segmentation));
    ASSERT_EQ(segmentation.planes.size(), 2u);
    for (std::size_t i = 1; i + 1 < room.labels.size(); ++i)
      ASSERT_EQ(segmentation.labels[i], usual.labels[i] == 3 ? 0 : usual.labels[i]) << i;
    EXPECT_EQ(segmentation.labels.front(), 0);
    EXPECT_EQ(segmentation.labels.back(), 0);
  }
}

TEST(PlaneFit, OtherLabelsCountAsNoneWhereNothingIsMeasured) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  const auto usual = fitted(room, *SensorModel::preset("d435i"), 3);
  room.labels = usual.labels;  // in order: nothing else changes them
  for (const std::size_t pixel : {std::size_t{3}, std::size_t{17}, room.labels.size() - 1}) {
    const float depth = room.depth[pixel];
    const std::int32_t label = room.labels[pixel];
    room.depth[pixel] = 0.0f;
    room.labels[pixel] = pixel == 17 ? -1 : 4;
    epcc::test::onEveryVectorUnit(
        [&] { EXPECT_EQ(fitted(room, *SensorModel::preset("d435i"), 3).labels[pixel], 0) << pixel; });
    room.depth[pixel] = depth;
    room.labels[pixel] = label;
  }
}

TEST(PlaneFit, RefusesLabelsOfAnotherSizeAndANegativeCount) {
  const auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  const auto refused = [&](std::size_t labels, int plane_count) {
    PlaneSegmentation segmentation;
    segmentation.planes.resize(2);
    segmentation.labels.assign(labels, 1);
    const bool done = epcc::fitPlanes(room.frame(), *SensorModel::preset("d435i"), plane_count, segmentation);
    return !done && segmentation.planes.empty() && segmentation.labels == std::vector<std::int32_t>(labels, 1);
  };
  EXPECT_TRUE(refused(room.labels.size() - 1, 1));
  EXPECT_TRUE(refused(room.labels.size() + 1, 1));
  EXPECT_TRUE(refused(0, 1));
  EXPECT_TRUE(refused(room.labels.size(), -1));
}

TEST(PlaneFit, CentroidAndPointCovarianceAreThoseOfThePoints) {
  const auto room = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(40, 30));
  const auto result = fitted(room, *SensorModel::preset("d435i"), 1);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), p;
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  const auto each = [&](const auto& visit) {
    for (int row = 0; row < 30; ++row)
      for (int column = 0; column < 40; ++column)
        if (room.frame().point(row, column, p)) visit();
  };
  each([&] { mean += p / 1200.0; });
  each([&] { squares += (p - mean) * (p - mean).transpose() / 1200.0; });
  EXPECT_EQ(result.planes[0].pixel_count, 1200u);
  EXPECT_LT((result.planes[0].centroid - mean).norm(), 1e-9);
  EXPECT_LT((result.planes[0].points_covariance - squares).norm(), 1e-9);
}

// A depth image is summed row by row with shared rays, a transposed view point by point: the same planes.
TEST(PlaneFit, RowsOfADepthImageGiveWhatItsPointsGive) {
  const SensorModel sensor = SensorModel::axial(0.002, 0.003);
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  epcc::test::addNoise(room, sensor, 3);
  for (std::size_t i = 0; i < room.depth.size(); ++i) {
    if (i % 11 == 0) room.depth[i] = 0.0f;  // holes, also where a run of a label starts
    if (i % 50 < 9) room.labels[i] = 0;     // several runs of a label in a row
  }
  const auto rows = fitted(room, sensor, 3);
  PlaneSegmentation points;
  points.labels = room.labels;
  epcc::fitPlanes(room.frame().transposed(), sensor, 3, points);
  ASSERT_EQ(rows.planes.size(), 3u);
  ASSERT_EQ(points.planes.size(), 3u);
  EXPECT_EQ(rows.labels, points.labels);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& a = rows.planes[k];
    const auto& b = points.planes[k];
    EXPECT_EQ(a.pixel_count, b.pixel_count);
    EXPECT_LT((a.coefficients - b.coefficients).norm(), 1e-9);
    EXPECT_LT((a.centroid - b.centroid).norm(), 1e-9);
    EXPECT_LT((a.points_covariance - b.points_covariance).norm(), 1e-9);
    EXPECT_NEAR(a.rms, b.rms, 1e-9);
    EXPECT_LT((a.coefficients_covariance - b.coefficients_covariance).norm(), 1e-6 * b.coefficients_covariance.norm());
  }
}

TEST(PlaneFit, CovariancePredictsTheScatterOfRepeatedFits) {
  const SensorModel white = SensorModel::axial(0.005, 0.0, 0.1);  // one pixel a sample
  const int runs = 200;
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  Eigen::Vector4d squares = Eigen::Vector4d::Zero();
  Eigen::Vector4d predicted = Eigen::Vector4d::Zero();
  for (int run = 0; run < runs; ++run) {
    auto room = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(40, 30));
    epcc::test::addNoise(room, white, static_cast<unsigned>(run));
    const auto plane = fitted(room, white, 1).planes[0];
    sum += plane.coefficients;
    squares += plane.coefficients.cwiseAbs2();
    predicted += plane.coefficients_covariance.diagonal() / runs;
  }
  const Eigen::Vector4d variance = (squares - sum.cwiseAbs2() / runs) / (runs - 1);
  for (const int k : {0, 1, 3}) EXPECT_NEAR(variance(k) / predicted(k), 1.0, 0.3) << k;
}

TEST(PlaneFit, Equation28ProjectsOnThePlane) {
  epcc::Plane plane;
  plane.coefficients << 0.0, 0.6, -0.8, 2.0;
  const Eigen::Vector3d p(0.3, -0.2, 2.0);
  const Eigen::Vector3d q = plane.project(p);
  EXPECT_NEAR(plane.signedDistance(q), 0.0, 1e-12);
  EXPECT_NEAR((p - q).cross(plane.coefficients.head<3>()).norm(), 0.0, 1e-12);
}

/// Fit of one label as its definition says, in double precision, from every stride-th row and column.
epcc::Plane plainFit(const DepthFrame& frame, const SensorModel& sensor, const std::vector<std::int32_t>& labels,
                     std::int32_t label, int stride, int offset, double samples_per_independent) {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> weights;
  epcc::Plane plane;
  Eigen::Vector3d p;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) {
      if (labels[frame.index(row, column)] != label || !frame.point(row, column, p)) continue;
      ++plane.pixel_count;
      if (row % stride != offset || column % stride != offset) continue;
      points.push_back(p);
      weights.push_back(1.0 / sensor.varianceZ(isPerspective(frame.projection()) ? std::abs(p.z()) : p.norm()));
    }
  double weight = 0.0;
  Eigen::Vector3d weighted_mean = Eigen::Vector3d::Zero();
  const auto n = static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    plane.centroid += points[i] / n;
    weighted_mean += weights[i] * points[i];
    weight += weights[i];
  }
  weighted_mean /= weight;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    plane.points_covariance += (points[i] - plane.centroid) * (points[i] - plane.centroid).transpose() / n;
    scatter += weights[i] * (points[i] - weighted_mean) * (points[i] - weighted_mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  Eigen::Vector3d normal = solver.eigenvectors().col(0);
  if (normal.dot(weighted_mean) > 0.0) normal = -normal;
  plane.coefficients << normal, -normal.dot(weighted_mean);
  double squares = 0.0;
  for (const auto& point : points) squares += std::pow(plane.signedDistance(point), 2);
  plane.rms = std::sqrt(squares / n);
  const double unit = solver.eigenvalues()(0) / (n - 3.0) * samples_per_independent;
  Eigen::Matrix3d tilt = Eigen::Matrix3d::Zero();
  for (int k = 1; k < 3; ++k)
    tilt += unit / solver.eigenvalues()(k) * solver.eigenvectors().col(k) * solver.eigenvectors().col(k).transpose();
  plane.coefficients_covariance.topLeftCorner<3, 3>() = tilt;
  plane.coefficients_covariance.topRightCorner<3, 1>() = -tilt * weighted_mean;
  plane.coefficients_covariance.bottomLeftCorner<1, 3>() = -(tilt * weighted_mean).transpose();
  plane.coefficients_covariance(3, 3) = weighted_mean.dot(tilt * weighted_mean) + unit / weight;
  return plane;
}

/// The step along the rays as its definition says, from every pixel of the grid: normal equations of theta = -normal /
/// d.
epcc::Plane plainStep(const DepthFrame& frame, const SensorModel& sensor, const std::vector<std::int32_t>& labels,
                      std::int32_t label, int stride, int offset, epcc::Plane plane) {
  const bool is_range = !isPerspective(frame.projection());
  Eigen::Vector3d theta = -Eigen::Vector3d(plane.coefficients.head<3>()) / plane.coefficients(3);
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero(), p;
  for (int row = offset; row < frame.height(); row += stride)
    for (int column = offset; column < frame.width(); column += stride) {
      if (labels[frame.index(row, column)] != label || !frame.point(row, column, p)) continue;
      const double depth = is_range ? p.norm() : std::abs(p.z());
      const Eigen::Vector3d ray = p / depth;
      const double w = theta.dot(ray);
      if (w * depth <= 0.5 || w * depth >= 2.0) continue;
      const double weight = 1.0 / (sensor.varianceZ(1.0 / w) * std::pow(w, 4));
      information += weight * ray * ray.transpose();
      gradient += weight * w * (1.0 - w * depth) * ray;
    }
  theta += information.fullPivLu().solve(gradient);
  plane.coefficients << -theta / theta.norm(), 1.0 / theta.norm();
  plane.rms = std::sqrt(plane.coefficients.head<3>().dot(plane.points_covariance * plane.coefficients.head<3>()) +
                        std::pow(plane.signedDistance(plane.centroid), 2));
  return plane;
}

/// Both steps; the covariance is checked on its own, by what it is to predict.
void expectFitted(const epcc::Plane& plane, const DepthFrame& frame, const SensorModel& sensor,
                  const std::vector<std::int32_t>& labels, std::int32_t label, int stride, int offset) {
  const auto expected = plainStep(frame, sensor, labels, label, stride, offset,
                                  plainFit(frame, SensorModel::axial(1.0, 0.0), labels, label, stride, offset, 1.0));
  EXPECT_EQ(plane.pixel_count, expected.pixel_count);
  EXPECT_LT((plane.coefficients - expected.coefficients).norm(), 1e-6 * expected.coefficients.norm());
  EXPECT_LT((plane.centroid - expected.centroid).norm(), 1e-6 * expected.centroid.norm());
  EXPECT_LT((plane.points_covariance - expected.points_covariance).norm(), 1e-6 * expected.points_covariance.norm());
  EXPECT_NEAR(plane.rms, expected.rms, 1e-6 * expected.rms);
}

void expectNear(const epcc::Plane& a, const epcc::Plane& b) {
  EXPECT_EQ(a.pixel_count, b.pixel_count);
  EXPECT_LT((a.coefficients - b.coefficients).norm(), 1e-6 * b.coefficients.norm());
  EXPECT_LT((a.centroid - b.centroid).norm(), 1e-6 * b.centroid.norm());
  EXPECT_LT((a.points_covariance - b.points_covariance).norm(), 1e-6 * b.points_covariance.norm());
  EXPECT_NEAR(a.rms, b.rms, 1e-6 * b.rms);
  EXPECT_LT((a.coefficients_covariance - b.coefficients_covariance).norm(), 1e-6 * b.coefficients_covariance.norm());
}

/// A noisy corner of a room with holes, and labels in short and long runs, some of them strangers; `mixed` ones are on
/// points of other planes too.
epcc::test::RenderedRoom labelledRoom(int width, int height, bool mixed = true) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(width, height));
  epcc::test::addNoise(room, SensorModel::axial(0.002, 0.003), 3);
  for (std::size_t i = 0; i < room.depth.size(); ++i) {
    if (i % 11 == 0) room.depth[i] = 0.0f;
    if (i % 13 == 5) room.labels[i] = 0;
    if (mixed && i % 50 < 9) room.labels[i] = static_cast<std::int32_t>(1 + i % 3);
    if (i % 97 == 0) room.labels[i] = 77;
  }
  return room;
}

TEST(PlaneFit, IsThatOfPlainSumsInDoublePrecision) {
  const SensorModel sensors[] = {SensorModel::axial(0.002, 0.003, 2.0),
                                 SensorModel::polynomial(0.006954, -0.003713, 0.001153, 0.1)};
  for (const auto& [width, height, mixed] :
       {std::tuple<int, int, bool>{160, 120, false}, {61, 40, false}, {160, 120, true}, {61, 40, true}, {7, 200, true}})
    for (const SensorModel& sensor : sensors) {
      const auto room = labelledRoom(width, height, mixed);
      std::vector<float> cloud, scan;
      Eigen::Vector3d p;
      for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
          if (!room.frame().point(row, column, p)) p.setConstant(std::numeric_limits<double>::quiet_NaN());
          for (const double value : {p.x(), -p.y(), -p.z(), 0.0}) cloud.push_back(static_cast<float>(value));
          for (const double value : {p.z(), -p.x(), -p.y()}) scan.push_back(static_cast<float>(value));
        }
      const auto backward = epcc::Projection::PerspectiveBackward;
      for (const DepthFrame& frame :
           {room.frame(), room.frame().transposed(), DepthFrame::fromPoints(cloud.data(), 4, width, height, backward),
            DepthFrame::fromPoints(scan.data(), 3, width, height, epcc::Projection::Spherical)}) {
        PlaneSegmentation segmentation, orthogonal;
        segmentation.labels = orthogonal.labels = room.labels;
        ASSERT_TRUE(epcc::fitPlanes(frame, sensor, 3, segmentation));
        ASSERT_EQ(segmentation.planes.size(), 3u);
        ASSERT_TRUE(epcc::PlaneFitter().fit(frame, sensor, 3, {1, 0, false}, 1, orthogonal));
        ASSERT_EQ(orthogonal.labels, segmentation.labels);
        for (std::int32_t k = 1; k <= 3; ++k) {
          const auto i = static_cast<std::size_t>(k - 1);
          if (!mixed) expectFitted(segmentation.planes[i], frame, sensor, segmentation.labels, k, 1, 0);
          expectNear(orthogonal.planes[i],
                     plainFit(frame, sensor, segmentation.labels, k, 1, 0, sensor.pixelsPerSample()));
        }
      }
    }
}

TEST(PlaneFit, ASampleGridGivesTheSumsAndEveryPixelTheCount) {
  auto room = labelledRoom(320, 240, false);
  for (std::size_t i = 0; i < room.labels.size(); ++i)
    if (room.depth[i] == 0.0f) room.labels[i] = 0;
  const SensorModel sensor = SensorModel::axial(0.002, 0.003, 2.0);  // 25 pixels a sample
  for (const auto& [stride, offset] : {std::pair<int, int>{2, 1}, {3, 1}, {3, 0}, {6, 3}}) {
    PlaneSegmentation segmentation;
    segmentation.labels = room.labels;
    epcc::PlaneFitter fitter;
    ASSERT_TRUE(fitter.fit(room.frame(), sensor, 3, {stride, offset}, 1, segmentation));
    ASSERT_EQ(segmentation.planes.size(), 3u);
    for (std::int32_t k = 1; k <= 3; ++k)
      expectFitted(segmentation.planes[static_cast<std::size_t>(k - 1)], room.frame(), sensor, segmentation.labels, k,
                   stride, offset);
  }
}

// Labels on points of several planes: a step from the plane between them would go anywhere, some times behind the
// sensor.
TEST(PlaneFit, PointsOfNoPlaneKeepTheOrthogonalFit) {
  const auto room = labelledRoom(7, 200);
  const SensorModel sensor = SensorModel::axial(0.002, 0.003);
  PlaneSegmentation along_rays, orthogonal;
  along_rays.labels = orthogonal.labels = room.labels;
  ASSERT_TRUE(epcc::fitPlanes(room.frame(), sensor, 3, along_rays));
  ASSERT_TRUE(epcc::PlaneFitter().fit(room.frame(), SensorModel::axial(1.0, 0.0), 3, {1, 0, false}, 1, orthogonal));
  ASSERT_EQ(along_rays.planes.size(), 3u);
  int kept = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& a = along_rays.planes[k];
    const auto& b = orthogonal.planes[k];
    kept += (a.coefficients - b.coefficients).norm() < 1e-9 ? 1 : 0;
    EXPECT_GT(a.coefficients.head<3>().dot(b.coefficients.head<3>()), 0.8) << k;
  }
  EXPECT_GT(kept, 0);
}

// Planes that the grid misses are fitted all the same.
TEST(PlaneFit, APlaneBetweenTheSamplesIsFittedToAllOfItsPixels) {
  auto room = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera());
  const SensorModel sensor = SensorModel::axial(0.002, 0.003, 2.0);
  epcc::test::addNoise(room, sensor, 5);
  for (std::size_t i = 0; i < room.labels.size(); ++i) {
    const std::size_t row = i / 160, column = i % 160;
    room.labels[i] = row > 20 && row < 27 && column % 4 == 1 ? 2 : 1;
  }
  PlaneSegmentation segmentation;
  segmentation.labels = room.labels;
  epcc::PlaneFitter fitter;
  ASSERT_TRUE(fitter.fit(room.frame(), sensor, 2, {4, 2}, 1, segmentation));
  ASSERT_EQ(segmentation.planes.size(), 2u);
  expectFitted(segmentation.planes[1], room.frame(), sensor, segmentation.labels, 2, 1, 0);
}

TEST(PlaneFit, HasTheSameBitsOnEveryUnitAndWithAnyNumberOfThreads) {
  const auto room = labelledRoom(163, 120);
  const SensorModel sensor = SensorModel::axial(0.002, 0.003, 2.0);
  std::vector<float> cloud;
  Eigen::Vector3d p;
  for (int row = 0; row < 120; ++row)
    for (int column = 0; column < 163; ++column) {
      if (!room.frame().point(row, column, p)) p.setConstant(std::numeric_limits<double>::quiet_NaN());
      for (const double value : {p.z(), -p.x(), -p.y()}) cloud.push_back(static_cast<float>(value));
    }
  const auto scan = DepthFrame::fromPoints(cloud.data(), 3, 163, 120, epcc::Projection::Spherical);
  for (const DepthFrame& frame : {room.frame(), scan})
    for (const int stride : {1, 2, 3}) {
      PlaneSegmentation first;
      epcc::test::onEveryVectorUnit([&] {
        for (const int threads : {1, 2, 5}) {
          PlaneSegmentation segmentation;
          segmentation.labels = room.labels;
          epcc::PlaneFitter fitter;
          ASSERT_TRUE(fitter.fit(frame, sensor, 3, {stride, stride / 2}, threads, segmentation));
          if (first.planes.empty()) first = segmentation;
          ASSERT_EQ(segmentation.labels, first.labels);
          for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_EQ(segmentation.planes[k].coefficients, first.planes[k].coefficients);
            ASSERT_EQ(segmentation.planes[k].coefficients_covariance, first.planes[k].coefficients_covariance);
          }
        }
      });
    }
}

// Lent counts take the place of counting, for one frame.
TEST(PlaneFit, LentCountsAreThoseOfThePlanes) {
  const auto room = labelledRoom(160, 120);
  const SensorModel sensor = SensorModel::axial(0.002, 0.003, 2.0);
  PlaneSegmentation counted, lent;
  counted.labels = lent.labels = room.labels;
  for (auto* labels : {&counted.labels, &lent.labels})
    for (std::int32_t& label : *labels) label = label == 77 ? 0 : label;
  std::vector<long> pixels(3, 0);
  for (const std::int32_t label : lent.labels)
    if (label > 0) ++pixels[static_cast<std::size_t>(label - 1)];
  epcc::PlaneFitter fitter;
  ASSERT_TRUE(fitter.fit(room.frame(), sensor, 3, {2, 1}, 1, counted));
  fitter.lendCounts(pixels.data());
  ASSERT_TRUE(fitter.fit(room.frame(), sensor, 3, {2, 1}, 1, lent));
  EXPECT_EQ(lent.labels, counted.labels);
  pixels.assign(3, 5);  // and are forgotten
  PlaneSegmentation again;
  again.labels = counted.labels;
  ASSERT_TRUE(fitter.fit(room.frame(), sensor, 3, {2, 1}, 1, again));
  ASSERT_EQ(lent.planes.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(lent.planes[k].pixel_count, counted.planes[k].pixel_count);
    EXPECT_EQ(lent.planes[k].coefficients, counted.planes[k].coefficients);
    EXPECT_EQ(again.planes[k].pixel_count, counted.planes[k].pixel_count);
  }
}

// So do the depths of the samples that the reading of the image keeps.
TEST(PlaneFit, LentSampleDepthsAreThoseOfTheFrame) {
  const SensorModel sensor = SensorModel::axial(0.002, 0.003, 2.0);
  for (const int stride : {2, 3})
    for (const int width : {160, 157}) {
      const auto room = labelledRoom(width, 119);
      PlaneSegmentation own, lent, again;
      own.labels = lent.labels = again.labels = room.labels;
      epcc::InverseDepthImage image;
      image.read(room.frame(), 2, stride);
      ASSERT_NE(image.sampleDepths(), nullptr);
      epcc::PlaneFitter fitter;
      ASSERT_TRUE(fitter.fit(room.frame(), sensor, 3, {stride, stride / 2}, 1, own));
      fitter.lendSampleDepth(image.sampleDepths());
      ASSERT_TRUE(fitter.fit(room.frame(), sensor, 3, {stride, stride / 2}, 1, lent));
      image.read(room.frame());
      EXPECT_EQ(image.sampleDepths(), nullptr);
      ASSERT_TRUE(fitter.fit(room.frame(), sensor, 3, {stride, stride / 2}, 1, again));
      ASSERT_EQ(lent.planes.size(), 3u);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(lent.planes[k].coefficients, own.planes[k].coefficients);
        EXPECT_EQ(again.planes[k].coefficients, own.planes[k].coefficients);
      }
    }
}

TEST(PlaneFit, AFitterForgetsTheFrameBefore) {
  const SensorModel sensor = SensorModel::axial(0.002, 0.003, 2.0);
  epcc::PlaneFitter fitter;
  for (const auto& [width, height, stride] : {std::tuple<int, int, int>{160, 120, 1}, {60, 50, 2}, {60, 50, 1}}) {
    const auto room = labelledRoom(width, height);
    PlaneSegmentation fresh, again;
    fresh.labels = again.labels = room.labels;
    ASSERT_TRUE(fitter.fit(room.frame(), sensor, 3, {stride, 0}, 1, again));
    ASSERT_TRUE(epcc::PlaneFitter().fit(room.frame(), sensor, 3, {stride, 0}, 1, fresh));
    ASSERT_EQ(again.labels, fresh.labels);
    ASSERT_EQ(again.planes.size(), fresh.planes.size());
    for (std::size_t k = 0; k < fresh.planes.size(); ++k)
      ASSERT_EQ(again.planes[k].coefficients_covariance, fresh.planes[k].coefficients_covariance);
  }
}

}  // namespace
