// SPDX-License-Identifier: BSD-3-Clause
// Scan lines of 16-bit values, or of floats, with a scale are read as DepthFrame reads images of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "epcc_segmentation/sensor_estimation.h"
#include "epcc_segmentation/vector_unit.h"
#include "tests/support/rendered_room.h"
#include "tests/support/spinning_scanner.h"
#include "tests/support/streamed_frame.h"

namespace epcc {
namespace {

constexpr double kMillimetres = 0.001;

/// Leaves the vector unit as it was.
class ScaledLines : public ::testing::Test {
 protected:
  ScaledLines() { options_.sensor = SensorModel::axial(0.003, 0.001, 2.0); }
  ~ScaledLines() override { setVectorUnit(before_); }

  /// A noisy room in units of `scale` metres, a tenth of it not measured in one way or the other.
  std::vector<std::uint16_t> unitsOf(double scale) {
    auto room = test::renderRoom(test::cornerPlanes(), camera_);
    test::addNoise(room, *options_.sensor, 5);
    std::mt19937 random(7);
    std::vector<std::uint16_t> units;
    for (const float z : room.depth) {
      const auto draw = random() % 20;
      const double whole = std::min(65534.0, std::round(static_cast<double>(z) / scale));
      units.push_back(draw == 0 ? 0 : draw == 1 ? 65535 : static_cast<std::uint16_t>(whole));
    }
    return units;
  }

  PinholeCamera camera_ = test::testCamera(161, 121);  // no multiple of what vectors hold
  StreamOptions options_;

 private:
  std::string before_ = vectorUnit();
};

TEST_F(ScaledLines, HaveTheLabelsAndPlanesOfTheWholeImageOnEveryVectorUnit) {
  for (const double scale : {kMillimetres, 0.0001, 0.0125}) {
    const std::vector<std::uint16_t> units = unitsOf(scale);
    const DepthView<std::uint16_t> view{units.data(), camera_.width, camera_.height, 0, scale};
    for (const std::string& unit : vectorUnits())
      for (const bool rows : {false, true}) {
        SCOPED_TRACE(unit + (rows ? ", rows of " : ", columns of ") + std::to_string(scale) + " m");
        ASSERT_TRUE(setVectorUnit(unit));
        PlaneExtractor extractor(test::wholeFrameParameters({}, rows), options_.sensor);
        PlaneSegmentation whole;
        ASSERT_TRUE(extractor.extract(DepthFrame::fromDepth(view, camera_), whole)) << extractor.error();
        ASSERT_GE(whole.planes.size(), scale > 0.001 ? 1u : 3u);
        ScanLineStream stream(rows ? StreamGeometry::cameraRows(camera_) : StreamGeometry::cameraColumns(camera_),
                              options_);
        const int lines = rows ? camera_.height : camera_.width;
        test::StreamedFrame streamed(stream, lines, rows ? camera_.width : camera_.height);
        for (int i = 0; i < lines; ++i) {
          const bool taken = rows ? stream.addRow(i, units.data() + i * camera_.width, 1, scale)
                                  : stream.addColumn(i, units.data() + i, camera_.width, scale);
          ASSERT_TRUE(taken) << stream.error();
        }
        ASSERT_TRUE(stream.finish());
        test::expectTheFrame(streamed, whole, rows);
      }
  }
}

TEST_F(ScaledLines, OfFloatsHaveAScaleAsWell) {
  const std::vector<std::uint16_t> units = unitsOf(kMillimetres);
  std::vector<float> millimetres;
  for (const std::uint16_t value : units) millimetres.push_back(value == 65535 ? NAN : static_cast<float>(value));
  const DepthView<float> view{millimetres.data(), camera_.width, camera_.height, 0, kMillimetres};
  for (const bool rows : {false, true}) {
    SCOPED_TRACE(rows ? "rows" : "columns");
    PlaneExtractor extractor(test::wholeFrameParameters({}, rows), options_.sensor);
    PlaneSegmentation whole;
    ASSERT_TRUE(extractor.extract(DepthFrame::fromDepth(view, camera_), whole)) << extractor.error();
    ScanLineStream stream(rows ? StreamGeometry::cameraRows(camera_) : StreamGeometry::cameraColumns(camera_),
                          options_);
    const int lines = rows ? camera_.height : camera_.width;
    test::StreamedFrame streamed(stream, lines, rows ? camera_.width : camera_.height);
    for (int i = 0; i < lines; ++i)
      ASSERT_TRUE(rows ? stream.addRow(i, millimetres.data() + i * camera_.width, 1, kMillimetres)
                       : stream.addColumn(i, millimetres.data() + i, camera_.width, kMillimetres));
    ASSERT_TRUE(stream.finish());
    ASSERT_GE(streamed.planes().size(), 3u);
    test::expectTheFrame(streamed, whole, rows);
  }
  ScanLineStream scanner(test::SpinningScanner().geometry(), options_);
  EXPECT_FALSE(scanner.addColumnAt(0.0, millimetres.data(), 1, -1.0));
  EXPECT_EQ(scanner.status(), Status::InvalidCamera);
  EXPECT_TRUE(scanner.addColumnAt(0.0, millimetres.data(), 1, kMillimetres)) << scanner.error();
}

TEST_F(ScaledLines, AreMillimetresUnlessTheScaleSaysOtherwise) {
  const std::vector<std::uint16_t> wall(static_cast<std::size_t>(camera_.width), 2000);
  ScanLineStream columns(StreamGeometry::cameraColumns(camera_), options_);
  ScanLineStream rows(StreamGeometry::cameraRows(camera_), options_);
  for (ScanLineStream* stream : {&columns, &rows}) {
    std::vector<StreamPlane> planes;
    stream->onPlane([&planes](const StreamPlane& plane) { planes.push_back(plane); });
    for (int i = 0; i < 60; ++i)
      ASSERT_TRUE(stream == &rows ? rows.addRow(i, wall.data()) : columns.addColumn(i, wall.data()));
    ASSERT_TRUE(stream->finish());
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_NEAR(planes[0].plane.coefficients(3), 2.0, 1e-6);
  }
}

TEST_F(ScaledLines, OfAScannerAreItsRangesInMetres) {
  constexpr double kScale = 0.004;
  test::SpinningScanner scanner;
  scanner.noise = 0.004;
  std::mt19937 random(3);
  std::vector<std::vector<std::uint16_t>> turn;
  std::vector<std::vector<float>> metres;
  for (int column = 0; column < scanner.columns; ++column) {
    turn.emplace_back();
    metres.emplace_back();
    for (const float range : scanner.ranges(column, random)) {
      const auto units = std::isnan(range) ? 65535 : static_cast<std::uint16_t>(std::lround(range / kScale));
      turn.back().push_back(static_cast<std::uint16_t>(units));
      metres.back().push_back(units == 65535 ? NAN : static_cast<float>(units * kScale));
    }
  }
  for (const bool at : {false, true}) {
    SCOPED_TRACE(at ? "at azimuths" : "by index");
    std::vector<StreamPlane> planes[2];
    for (const bool whole_numbers : {false, true}) {
      ScanLineStream stream(scanner.geometry(), options_);
      stream.onPlane([&](const StreamPlane& plane) { planes[whole_numbers ? 1 : 0].push_back(plane); });
      for (int c = 0; c < scanner.columns; ++c) {
        const auto i = static_cast<std::size_t>(c);
        const double azimuth = scanner.azimuth(c);
        bool taken = false;
        if (at)
          taken = whole_numbers ? stream.addColumnAt(azimuth, turn[i].data(), 1, kScale)
                                : stream.addColumnAt(azimuth, metres[i].data());
        else
          taken = whole_numbers ? stream.addColumn(c, azimuth, turn[i].data(), 1, kScale)
                                : stream.addColumn(c, azimuth, metres[i].data());
        ASSERT_TRUE(taken) << stream.error();
      }
      ASSERT_TRUE(stream.finish());
    }
    ASSERT_GE(planes[0].size(), 5u);
    ASSERT_EQ(planes[0].size(), planes[1].size());
    for (std::size_t i = 0; i < planes[0].size(); ++i) {
      EXPECT_EQ(planes[0][i].first_line, planes[1][i].first_line);
      EXPECT_EQ(planes[0][i].plane.pixel_count, planes[1][i].plane.pixel_count);
      EXPECT_EQ(planes[0][i].plane.coefficients, planes[1][i].plane.coefficients) << "to the bit";
    }
  }
}

TEST_F(ScaledLines, AreMeasuredOnAsTheWholeImageIs) {
  camera_ = test::testCamera(320, 240);
  const std::vector<std::uint16_t> units = unitsOf(kMillimetres);
  const DepthView<std::uint16_t> view{units.data(), camera_.width, camera_.height};
  const auto estimate = estimateSensor(DepthFrame::fromDepth(view, camera_));
  ASSERT_GT(estimate.blocks, 10u);
  ScanLineStream stream(StreamGeometry::cameraRows(camera_), StreamOptions());
  for (int row = 0; row < camera_.height; ++row) ASSERT_TRUE(stream.addRow(row, units.data() + row * camera_.width));
  ASSERT_TRUE(stream.finish());
  EXPECT_EQ(stream.measuredBlocks(), estimate.blocks);
  EXPECT_EQ(stream.sensor().sigmaZ(2.0), estimate.model().sigmaZ(2.0));
}

TEST_F(ScaledLines, WithAScaleThatIsNoneAreLeftOutAndTheStreamGoesOn) {
  const std::vector<std::uint16_t> wall(static_cast<std::size_t>(camera_.width), 2000);
  ScanLineStream rows(StreamGeometry::cameraRows(camera_), options_);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double scale : {0.0, -0.001, 1000.5, infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(rows.addRow(0, wall.data(), 1, scale)) << scale;
    EXPECT_EQ(rows.status(), Status::InvalidCamera);
    EXPECT_EQ(rows.error(), "the scan line's scale must be positive, at most 1000 m a unit");
  }
  EXPECT_FALSE(rows.addRow(0, static_cast<const std::uint16_t*>(nullptr)));
  EXPECT_EQ(rows.status(), Status::EmptyCloud);
  EXPECT_FALSE(rows.addColumn(0, wall.data()));
  EXPECT_EQ(rows.status(), Status::UnsupportedScan);
  EXPECT_FALSE(rows.addColumnAt(0.0, wall.data()));
  EXPECT_EQ(rows.status(), Status::UnsupportedScan);
  EXPECT_EQ(rows.taken(), 0);
  for (int row = 0; row < 30; ++row) ASSERT_TRUE(rows.addRow(row, wall.data())) << rows.error();
  EXPECT_FALSE(rows.addRow(29, wall.data()));
  EXPECT_EQ(rows.status(), Status::OutOfOrder);
  EXPECT_TRUE(rows.addRow(30, wall.data(), 1, 1000.0)) << "too far to be measured is no error";
  EXPECT_EQ(rows.taken(), 31);

  ScanLineStream scanner(test::SpinningScanner().geometry(), options_);
  EXPECT_FALSE(scanner.addColumnAt(std::numeric_limits<double>::quiet_NaN(), wall.data()));
  EXPECT_EQ(scanner.status(), Status::InvalidParameters);
  EXPECT_FALSE(scanner.addColumnAt(0.0, wall.data(), 1, 0.0));
  EXPECT_EQ(scanner.status(), Status::InvalidCamera);
  EXPECT_FALSE(scanner.addColumn(0, 0.0, wall.data(), 1, -1.0));
  EXPECT_EQ(scanner.status(), Status::InvalidCamera);
}

}  // namespace
}  // namespace epcc
