// SPDX-License-Identifier: BSD-3-Clause
// The library's limits at their boundaries (docs/reference/limits.md), and what is promised not to throw.
#include <gtest/gtest.h>

#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "epcc_segmentation/cloud_geometry.h"
#include "epcc_segmentation/laser_line_extractor.h"
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/plane_tracker.h"
#include "epcc_segmentation/scan_line_stream.h"
#include "epcc_segmentation/sensor_estimation.h"

namespace epcc {
namespace {

template <typename T>
constexpr bool kMovesWithoutThrowing =
    std::is_nothrow_move_constructible_v<T>&& std::is_nothrow_move_assignable_v<T>&& std::is_nothrow_destructible_v<T>;
static_assert(kMovesWithoutThrowing<PlaneExtractor> && kMovesWithoutThrowing<ScanLineStream> &&
              kMovesWithoutThrowing<PlaneTracker> && kMovesWithoutThrowing<GeometryFinder> &&
              kMovesWithoutThrowing<SensorPool> && kMovesWithoutThrowing<DepthFrame> &&
              kMovesWithoutThrowing<SensorModel>);

template <typename T>
constexpr bool kTellsWithoutThrowing =
    noexcept(std::declval<const T&>().status()) && noexcept(std::declval<const T&>().error());
static_assert(kTellsWithoutThrowing<PlaneExtractor> && kTellsWithoutThrowing<ScanLineStream> &&
              kTellsWithoutThrowing<PlaneTracker> && kTellsWithoutThrowing<LaserLineExtractor>);
static_assert(
    noexcept(std::declval<const DepthFrame&>().status()) && noexcept(std::declval<const DepthFrame&>().empty()));

PinholeCamera cameraWith(double PinholeCamera::*number, double value) {
  PinholeCamera camera{4, 3, 100.0, 100.0, 1.5, 1.0};
  camera.*number = value;
  return camera;
}

TEST(LibraryLimits, FocusAndCentreOfACamera) {
  for (const auto number : {&PinholeCamera::fx, &PinholeCamera::fy}) {
    for (const double good : {0.001, 1e6}) EXPECT_EQ(cameraWith(number, good).validate(), "") << good;
    for (const double bad : {std::nextafter(0.001, 0.0), std::nextafter(1e6, 2e6), 0.0, -100.0})
      EXPECT_NE(cameraWith(number, bad).validate(), "") << bad;
  }
  for (const auto number : {&PinholeCamera::cx, &PinholeCamera::cy}) {
    for (const double good : {-1e6, 1e6}) EXPECT_EQ(cameraWith(number, good).validate(), "") << good;
    for (const double bad : {std::nextafter(-1e6, -2e6), std::nextafter(1e6, 2e6)})
      EXPECT_NE(cameraWith(number, bad).validate(), "") << bad;
  }
  const std::vector<float> depth(12, 1.0f);
  const DepthFrame frame = DepthFrame::fromDepth(depth.data(), cameraWith(&PinholeCamera::fx, 1.1e6));
  EXPECT_EQ(frame.status(), Status::InvalidCamera);
}

TEST(LibraryLimits, NumbersOfASensorModel) {
  EXPECT_EQ(SensorModel::axial(1000.0, 1000.0, 1000.0).validate(), "");
  EXPECT_EQ(SensorModel::axial(1e-9, 0.0, 0.0).validate(), "");
  const double more = std::nextafter(1000.0, 2000.0);
  for (const SensorModel& bad :
       {SensorModel::axial(more, 0.0), SensorModel::axial(0.0, more), SensorModel::axial(0.0, 0.0),
        SensorModel::axial(1.0, 0.0, more), SensorModel::axial(1.0, 0.0, -1e-9),
        SensorModel::polynomial(more, 0.0, 0.0), SensorModel::axial(-1e-9, 1.0)})
    EXPECT_NE(bad.validate(), "") << bad.description();
}

TEST(LibraryLimits, Threads) {
  const std::vector<float> depth(12, 1.0f);
  const DepthFrame frame = DepthFrame::fromDepth(depth.data(), {4, 3, 100.0, 100.0, 1.5, 1.0});
  PlaneSegmentation result;
  for (const auto& [threads, status] : {std::pair{1, Status::Ok},
                                        {256, Status::Ok},
                                        {0, Status::InvalidParameters},
                                        {257, Status::InvalidParameters}}) {
    Parameters parameters;
    parameters.threads = threads;
    PlaneExtractor extractor(parameters);
    EXPECT_EQ(extractor.extract(frame, result), status == Status::Ok) << threads;
    EXPECT_EQ(extractor.status(), status) << threads;
  }
}

// 65534 mm is a depth, 65535 none; of floats the least that has an inverse is one.
TEST(LibraryLimits, DepthsThatAreMeasured) {
  const PinholeCamera camera{4, 1, 100.0, 100.0, 1.5, 0.0};
  const std::uint16_t units[] = {0, 1, 65534, 65535};
  const float metres[] = {0.0f, std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max(),
                          std::numeric_limits<float>::infinity()};
  Eigen::Vector3d point;
  for (const DepthFrame& frame :
       {DepthFrame::fromDepth(DepthView<std::uint16_t>{units, 4, 1}, camera), DepthFrame::fromDepth(metres, camera)})
    for (int column = 0; column < 4; ++column)
      EXPECT_EQ(frame.point(0, column, point), column == 1 || column == 2) << column;
}

}  // namespace
}  // namespace epcc
