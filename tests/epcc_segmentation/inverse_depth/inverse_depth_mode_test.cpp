// SPDX-License-Identifier: BSD-3-Clause
// The inverse-depth mode as a whole: rooms with white and with blotchy error, laws, scans.
#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/support/rendered_room.h"

namespace {

using epcc::DepthFrame;
using epcc::Parameters;
using epcc::PlaneExtractor;
using epcc::PlaneSegmentation;
using epcc::ScanDirection;
using epcc::SensorModel;
using epcc::test::RenderedRoom;

const SensorModel kWhiteNoise = SensorModel::axial(0.003, 0.001, 1.0);

RenderedRoom roomWithWhiteNoise(unsigned seed = 1, int width = 320, int height = 240) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(width, height));
  epcc::test::addNoise(room, kWhiteNoise, seed);
  return room;
}

PlaneSegmentation extractDefault(const DepthFrame& frame, const Parameters& parameters = {},
                                 const SensorModel& sensor = kWhiteNoise) {
  PlaneExtractor extractor(parameters, sensor);
  PlaneSegmentation result;
  EXPECT_TRUE(extractor.extract(frame, result)) << extractor.error();
  return result;
}

double agreement(const RenderedRoom& room, const PlaneSegmentation& result) {
  std::map<std::pair<std::int32_t, std::int32_t>, long> counts;
  for (std::size_t i = 0; i < room.labels.size(); ++i) ++counts[{room.labels[i], result.labels[i]}];
  std::map<std::int32_t, long> best;
  for (const auto& [pair, count] : counts)
    if (pair.second > 0) best[pair.first] = std::max(best[pair.first], count);
  long agree = 0;
  for (const auto& [surface, count] : best) agree += count;
  return static_cast<double>(agree) / static_cast<double>(room.labels.size());
}

TEST(InverseDepthMode, IsTheDefault) {
  EXPECT_EQ(Parameters().mode, epcc::Mode::InverseDepth);
  EXPECT_EQ(Parameters().scan, ScanDirection::Both);
  EXPECT_EQ(Parameters::forPaper().mode, epcc::Mode::Paper);
  EXPECT_EQ(Parameters::forPaper().scan, ScanDirection::Both);  // all that the mode has: columns
}

TEST(InverseDepthMode, ANoisyRoomIsExactlyItsThreePlanesInEveryScan) {
  for (const ScanDirection scan : {ScanDirection::Both, ScanDirection::Columns, ScanDirection::Rows})
    for (unsigned seed = 0; seed < 5; ++seed) {
      const auto room = roomWithWhiteNoise(seed);
      Parameters parameters;
      parameters.scan = scan;
      const auto result = extractDefault(room.frame(), parameters);
      EXPECT_EQ(result.planes.size(), 3u) << "seed " << seed;
      EXPECT_GT(agreement(room, result), 0.97) << "seed " << seed;
    }
}

TEST(InverseDepthMode, TransposingTheImageTransposesTheLabels) {
  const auto room = roomWithWhiteNoise();
  const auto& camera = room.camera;
  RenderedRoom transposed;
  transposed.camera = {camera.height, camera.width, camera.fy, camera.fx, camera.cy, camera.cx};
  for (int column = 0; column < camera.width; ++column)
    for (int row = 0; row < camera.height; ++row)
      transposed.depth.push_back(room.depth[static_cast<std::size_t>(row * camera.width + column)]);
  const auto a = extractDefault(room.frame());
  const auto b = extractDefault(transposed.frame());
  ASSERT_EQ(a.planes.size(), b.planes.size());
  long differ = 0;
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column)
      differ += a.labels[static_cast<std::size_t>(row * camera.width + column)] !=
                        b.labels[static_cast<std::size_t>(column * camera.height + row)]
                    ? 1
                    : 0;
  EXPECT_LT(differ, camera.width * camera.height / 200);  // ties between directions go to the columns
}

TEST(InverseDepthMode, ATransposedViewIsLabelledInTheCallersOrder) {
  const auto room = roomWithWhiteNoise();
  const auto turned = extractDefault(room.frame().transposed());
  ASSERT_EQ(turned.planes.size(), 3u);
  EXPECT_GT(agreement(room, turned), 0.97);
}

TEST(InverseDepthMode, RepeatedCallsAndFreshObjectsGiveTheSameBits) {
  const auto room = roomWithWhiteNoise(1);
  const auto other = roomWithWhiteNoise(2, 90, 70);
  PlaneExtractor extractor(Parameters(), kWhiteNoise);
  PlaneSegmentation first, second;
  ASSERT_TRUE(extractor.extract(room.frame(), first));
  ASSERT_TRUE(extractor.extract(other.frame(), second));
  ASSERT_TRUE(extractor.extract(room.frame(), second));
  EXPECT_EQ(first.labels, second.labels);
  EXPECT_EQ(first.labels, extractDefault(room.frame()).labels);
}

TEST(InverseDepthMode, TheNumberOfThreadsChangesNothing) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  epcc::test::addNoise(room, SensorModel::axial(0.002, 0.0, 1.0), 4);
  for (const int threads : {2, 3, 200})
    for (const auto scan : {epcc::ScanDirection::Both, epcc::ScanDirection::Columns, epcc::ScanDirection::Rows}) {
      Parameters parameters;
      parameters.scan = scan;
      const auto expected = extractDefault(room.frame(), parameters);
      parameters.threads = threads;
      EXPECT_EQ(extractDefault(room.frame(), parameters).labels, expected.labels) << threads;
    }
}

TEST(InverseDepthMode, BlotchyErrorLeavesTheWallsWholeWhereTheWhiteModelBreaksThem) {
  // Error correlated over eight pixels: white noise on a coarse grid, interpolated. Both models are larger than a pixel
  // is wide there, 4 mm: below that one model would be like the other.
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(320, 240));
  const int cell = 8;
  std::mt19937 generator(9);
  std::normal_distribution<double> normal(0.0, 0.015);
  std::vector<double> grid(static_cast<std::size_t>(42 * 32));
  for (auto& value : grid) value = normal(generator);
  for (int row = 0; row < 240; ++row)
    for (int column = 0; column < 320; ++column) {
      const int r = row / cell, c = column / cell;
      const double y = (row % cell) / 8.0, x = (column % cell) / 8.0;
      const auto at = [&](int i, int j) { return grid[static_cast<std::size_t>(i * 42 + j)]; };
      float& z = room.depth[static_cast<std::size_t>(row * 320 + column)];
      z += static_cast<float>((1 - y) * ((1 - x) * at(r, c) + x * at(r, c + 1)) +
                              y * ((1 - x) * at(r + 1, c) + x * at(r + 1, c + 1)));
    }
  Parameters as_given;  // one model is wrong on purpose
  as_given.inverse_depth.adapt_sensor = false;
  const auto blotchy = extractDefault(room.frame(), as_given, SensorModel::axial(0.015, 0.0, 5.0));
  const auto white = extractDefault(room.frame(), as_given, SensorModel::axial(0.005, 0.0, 1.0));
  EXPECT_EQ(blotchy.planes.size(), 3u);
  EXPECT_GT(agreement(room, blotchy), 0.95);
  EXPECT_GT(white.planes.size(), 6u);
}

TEST(InverseDepthMode, PatternsOfEmptyPixelsThatTheGridFallsIntoHideNothing) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(640, 480));
  epcc::test::addNoise(room, kWhiteNoise, 5);
  for (const int kind : {0, 1, 2}) {  // odd columns, odd rows, half of a checkerboard: the grid has odd ones
    auto sparse = room;
    for (int row = 0; row < 480; ++row)
      for (int column = 0; column < 640; ++column)
        if (kind == 0 ? column % 2 == 1 : kind == 1 ? row % 2 == 1 : (row + column) % 2 == 0)
          sparse.depth[static_cast<std::size_t>(row * 640 + column)] = 0.0f;
    const auto result = extractDefault(sparse.frame());
    std::size_t pixels = 0;
    for (const auto& plane : result.planes) pixels += plane.pixel_count;
    EXPECT_EQ(result.planes.size(), 3u) << kind;
    EXPECT_GT(pixels, 0.45 * 640 * 480) << kind;
  }
}

TEST(InverseDepthMode, FewPixelsInAPatternOrAtRandomAreEnough) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(640, 480));
  epcc::test::addNoise(room, kWhiteNoise, 5);
  std::mt19937 random(3);
  const auto keep = [&](int kind, int row, int column) {
    if (kind == 0) return row % 4 == 1;                      // every fourth ring
    if (kind == 1) return row % 6 == 2 + (column / 40 % 2);  // rings of a scanner in a camera's image
    if (kind == 2) return row % 2 == 0 && column % 2 == 0;   // a quarter
    return random() % 100 < (kind == 3 ? 25u : 10u);
  };
  for (const int kind : {0, 1, 2, 3, 4}) {
    auto sparse = room;
    std::size_t kept = 0, labelled = 0;
    for (int row = 0; row < 480; ++row)
      for (int column = 0; column < 640; ++column)
        if (keep(kind, row, column))
          ++kept;
        else
          sparse.depth[static_cast<std::size_t>(row * 640 + column)] = 0.0f;
    for (const bool measured : {false, true}) {
      PlaneExtractor extractor(Parameters(), measured ? std::nullopt : std::optional<SensorModel>(kWhiteNoise));
      PlaneSegmentation result;
      ASSERT_TRUE(extractor.extract(sparse.frame(), result));
      EXPECT_EQ(result.planes.size(), 3u) << kind << measured;
      labelled = 0;
      for (const auto& plane : result.planes) labelled += plane.pixel_count;
      EXPECT_GT(labelled, 0.9 * static_cast<double>(kept)) << kind << measured;
    }
  }
}

TEST(InverseDepthMode, SphericalScansTakeTheirColumns) {
  std::vector<float> xyz;
  for (int row = 0; row < 120; ++row)
    for (int column = 0; column < 200; ++column) {
      const double azimuth = (100 - column) * 0.4 * M_PI / 180.0;
      const double elevation = (60 - row) * 0.5 * M_PI / 180.0;
      const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                std::sin(elevation));
      double nearest = 1e9;
      for (const auto& plane : epcc::test::cornerPlanes()) {
        const double range = -plane(3) / Eigen::Vector3d(plane(2), -plane(0), -plane(1)).dot(ray);
        if (range > 0.0 && range < nearest) nearest = range;
      }
      for (int k = 0; k < 3; ++k) xyz.push_back(nearest < 50.0 ? static_cast<float>(nearest * ray(k)) : 0.0f);
    }
  const auto frame = DepthFrame::fromPoints(xyz.data(), 3, 200, 120, epcc::Projection::Spherical);
  const auto result = extractDefault(frame);
  ASSERT_EQ(result.planes.size(), 3u);
  for (const auto& plane : result.planes) EXPECT_LT(plane.rms, 0.01);
  Parameters rows;
  rows.scan = ScanDirection::Rows;
  PlaneExtractor by_rows(rows, kWhiteNoise);
  PlaneSegmentation none;
  EXPECT_FALSE(by_rows.extract(frame, none));
}

TEST(InverseDepthMode, BackwardCloudsAreSeenAsTheyAre) {
  const auto room = roomWithWhiteNoise();
  std::vector<float> xyz;
  Eigen::Vector3d p;
  for (int row = 0; row < room.camera.height; ++row)
    for (int column = 0; column < room.camera.width; ++column) {
      ASSERT_TRUE(room.frame().point(row, column, p));
      for (const double value : {p.x(), -p.y(), -p.z()}) xyz.push_back(static_cast<float>(value));
    }
  const auto projection = epcc::detectProjection(xyz.data(), 3, room.camera.width, room.camera.height);
  ASSERT_EQ(projection, epcc::Projection::PerspectiveBackward);
  const auto result =
      extractDefault(DepthFrame::fromPoints(xyz.data(), 3, room.camera.width, room.camera.height, projection));
  const auto forward = extractDefault(room.frame());
  ASSERT_EQ(result.planes.size(), 3u);
  EXPECT_GT(agreement(room, result), 0.97);
  EXPECT_GT(result.planes[0].coefficients(3), 0.0);
  EXPECT_NEAR(result.planes[0].coefficients(2), -forward.planes[0].coefficients(2), 0.01);
}

TEST(InverseDepthMode, DegenerateFramesHaveNoPlanes) {
  const std::vector<float> nothing(32 * 24, 0.0f);
  EXPECT_TRUE(extractDefault(DepthFrame::fromDepth(nothing.data(), epcc::test::testCamera(32, 24))).planes.empty());
  const std::vector<float> depth(500, 2.0f);
  EXPECT_TRUE(extractDefault(DepthFrame::fromDepth(depth.data(), {500, 1, 400.0, 400.0, 250.0, 0.0})).planes.empty());
  EXPECT_TRUE(extractDefault(DepthFrame::fromDepth(depth.data(), {1, 500, 400.0, 400.0, 0.0, 250.0})).planes.empty());
}

// Rays so steep that their spread is beyond a float, and points so far off that their weight is 0 times it.
TEST(InverseDepthMode, CloudsOfAbsurdNumbersAreSegmentedToTheEnd) {
  constexpr int kWidth = 40, kHeight = 30;
  for (const auto projection : {epcc::Projection::Perspective, epcc::Projection::Spherical}) {
    std::vector<float> xyz;
    for (int i = 0; i < kWidth * kHeight; ++i) {
      const bool steep = i % 11 == 0;
      xyz.insert(xyz.end(),
                 {steep ? 3e38f : 0.0f, steep ? 0.0f : 1e-3f * static_cast<float>(i % kWidth), steep ? 1e-38f : 3e38f});
    }
    const auto result = extractDefault(DepthFrame::fromPoints(xyz.data(), 3, kWidth, kHeight, projection));
    EXPECT_TRUE(result.planes.empty()) << "nothing is measured beyond 100 km";
  }
}

TEST(InverseDepthMode, HugeAndTinyDepthsHideNoPlane) {
  auto room = roomWithWhiteNoise();
  for (std::size_t i = 0; i < room.depth.size(); i += 7) room.depth[i] = i % 2 == 0 ? 3e38f : 1e-38f;
  const auto result = extractDefault(room.frame());
  ASSERT_EQ(result.planes.size(), 3u);
  for (const auto& truth : epcc::test::cornerPlanes()) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& plane : result.planes) nearest = std::min(nearest, (plane.coefficients - truth).norm());
    EXPECT_LT(nearest, 0.001) << truth.transpose();
  }
}

}  // namespace
