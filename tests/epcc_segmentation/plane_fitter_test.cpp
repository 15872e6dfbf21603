// SPDX-License-Identifier: BSD-3-Clause
// The fitter of a stream against plain sums in double precision: grids of samples, what is lent to it, units, threads.
#include "plane_fit_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "epcc_segmentation/plane_fit.h"
#include "inverse_depth/inverse_depth_image.h"
#include "tests/epcc_segmentation/plain_plane_fit.h"
#include "tests/support/rendered_room.h"
#include "tests/support/vector_units.h"

namespace {

using epcc::DepthFrame;
using epcc::PlaneSegmentation;
using epcc::SensorModel;
using epcc::test::expectFitted;
using epcc::test::expectNear;
using epcc::test::labelledRoom;
using epcc::test::plainFit;

TEST(PlaneFitter, IsThatOfPlainSumsInDoublePrecision) {
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

TEST(PlaneFitter, ASampleGridGivesTheSumsAndEveryPixelTheCount) {
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

// Labels on points of several planes: a step from the plane between them would go anywhere, sometimes behind the
// sensor.
TEST(PlaneFitter, PointsOfNoPlaneKeepTheOrthogonalFit) {
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
TEST(PlaneFitter, APlaneBetweenTheSamplesIsFittedToAllOfItsPixels) {
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

TEST(PlaneFitter, HasTheSameBitsOnEveryUnitAndWithAnyNumberOfThreads) {
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
TEST(PlaneFitter, LentCountsAreThoseOfThePlanes) {
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
TEST(PlaneFitter, RowsOfSparsePlanesAreAllThatIsReadOfThem) {
  auto room = labelledRoom(160, 120, false);
  for (int row = 50; row < 57; ++row)  // too few samples of stride 4
    for (int column = 30; column < 60; ++column) room.labels[static_cast<std::size_t>(row * 160 + column)] = 4;
  const SensorModel sensor = SensorModel::axial(0.002, 0.003, 5.0);
  const auto fitted = [&](const epcc::RowSpan* rows) {
    PlaneSegmentation segmentation;
    segmentation.labels = room.labels;
    epcc::PlaneFitter fitter;
    fitter.lendRows(rows);
    EXPECT_TRUE(fitter.fit(room.frame(), sensor, 4, {4, 2, true, 1}, 1, segmentation));
    return segmentation.planes.back();
  };
  const epcc::RowSpan all[] = {{0, 120}, {0, 120}, {0, 120}, {50, 57}};
  EXPECT_EQ(fitted(all).coefficients, fitted(nullptr).coefficients);
  EXPECT_EQ(fitted(all).coefficients_covariance, fitted(nullptr).coefficients_covariance);
  const epcc::RowSpan some[] = {{0, 120}, {0, 120}, {0, 120}, {52, 55}};
  EXPECT_NE(fitted(some).coefficients, fitted(nullptr).coefficients);
}

TEST(PlaneFitter, LentSampleDepthsAreThoseOfTheFrame) {
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

TEST(PlaneFitter, AFitterForgetsTheFrameBefore) {
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

/// A step from 2 m to 2.1 m in column 40 of 80, the border of whose labels is wrong by two pixels, and a slat of three
/// pixels before the farther side.
struct WrongBorder {
  epcc::PinholeCamera camera{80, 60, 100.0, 100.0, 39.5, 29.5};
  std::vector<float> depth;
  std::vector<std::int32_t> labels;
  WrongBorder() {
    for (int row = 0; row < 60; ++row)
      for (int column = 0; column < 80; ++column) {
        const bool is_slat = column >= 60 && column < 63;
        depth.push_back(is_slat ? 1.5f + 0.001f * static_cast<float>((row / 2) % 3) : column < 40 ? 2.0f : 2.1f);
        labels.push_back(is_slat ? 3 : column < 42 ? 1 : 2);
      }
  }
};

TEST(PlaneFitter, WhatLiesInTheMarginOfAnotherPlaneDoesNotCountButThinPlanesKeepAll) {
  const WrongBorder scene;
  const DepthFrame frame = DepthFrame::fromDepth(scene.depth.data(), scene.camera);
  for (const epcc::FitSamples& samples : {epcc::FitSamples{1, 0, true, 2}, epcc::FitSamples{2, 1, true, 1}}) {
    epcc::PlaneFitter fitter;
    for (int run = 0; run < 2; ++run) {  // with its memory too
      PlaneSegmentation result;
      result.labels = scene.labels;
      ASSERT_TRUE(fitter.fit(frame, SensorModel::axial(0.01, 0.0, 1.0), 3, samples, 1, result));
      ASSERT_EQ(result.planes.size(), 3u);
      EXPECT_NEAR(result.planes[0].coefficients(3), 2.0, 2e-4);
      EXPECT_NEAR(result.planes[1].coefficients(3), 2.1, 2e-4);
      EXPECT_NEAR(result.planes[2].coefficients(3), 1.5, 5e-3);
      EXPECT_GT(result.planes[2].coefficients_covariance.trace(), 0.0);
      epcc::FitSamples without = samples;
      without.margin = 0;
      PlaneSegmentation all;
      all.labels = scene.labels;
      ASSERT_TRUE(epcc::PlaneFitter().fit(frame, SensorModel::axial(0.01, 0.0, 1.0), 3, without, 1, all));
      EXPECT_GT(std::abs(all.planes[0].coefficients(3) - 2.0), 1e-3);
      EXPECT_EQ(all.planes[2].coefficients_covariance, result.planes[2].coefficients_covariance);
    }
  }
}

}  // namespace
