// SPDX-License-Identifier: BSD-3-Clause
// Frames at the edge of what a frame is, in every way to segment them.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <vector>

#include "tests/epcc_segmentation/properties/sound_result.h"

namespace epcc::test {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

std::vector<Way> allWays() {
  std::vector<Way> ways;
  for (const Mode mode : {Mode::InverseDepth, Mode::Paper})
    for (const bool is_measured : {false, true})
      for (const ScanDirection scan : {ScanDirection::Both, ScanDirection::Columns, ScanDirection::Rows})
        for (const int stride : {0, 3}) ways.push_back({mode, is_measured, scan, stride, 2, true});
  return ways;
}

/// A frame of one depth, in metres.
RandomFrame flatFrame(int width, int height, FrameKind kind = FrameKind::Depth) {
  RandomFrame frame({kind, Scene::Planes, width, height, 1, 0, 10, 0, false});
  frame.camera.cx = 0.5 * (width - 1);
  frame.camera.cy = 0.5 * (height - 1);
  for (float& z : frame.depth) z = 2.0f;
  for (std::uint16_t& z : frame.units) z = 2000;
  return frame;
}

/// Segments the frame in every way; `check` sees what comes out.
void inEveryWay(const RandomFrame& frame, const std::function<void(const PlaneSegmentation&, const Way&)>& check = {}) {
  for (const Way& way : allWays()) {
    SCOPED_TRACE(testing::Message() << frame.spec << ' ' << way);
    Parameters parameters = way.parameters();
    parameters.line_segments = true;
    PlaneExtractor extractor(parameters, way.sensor(frame.sensor()));
    PlaneSegmentation result;
    const bool done = extractor.extract(frame.frame(), result);
    if (frame.spec.kind == FrameKind::Scanner && way.scan == ScanDirection::Rows) {
      EXPECT_EQ(extractor.status(), Status::UnsupportedScan);
      continue;
    }
    ASSERT_TRUE(done) << extractor.error();
    EXPECT_EQ(resultProblem(result, frame), "");
    if (check) check(result, way);
  }
}

void expectNoPlane(const PlaneSegmentation& result, const Way& /*way*/) {
  EXPECT_TRUE(result.planes.empty());
}

TEST(DegenerateFrame, OfOneRowOrColumnHasNoPlane) {
  for (const int length : {1, 2, 31, 32, 33, 500}) {
    inEveryWay(flatFrame(length, 1), expectNoPlane);
    inEveryWay(flatFrame(1, length), expectNoPlane);
    inEveryWay(flatFrame(length, 1, FrameKind::WholeNumbers), expectNoPlane);
    for (const FrameKind kind : {FrameKind::Cloud, FrameKind::BackwardCloud, FrameKind::Scanner}) {
      inEveryWay(RandomFrame({kind, Scene::Planes, length, 1, 1, 1, 10, 0, false}));
      inEveryWay(RandomFrame({kind, Scene::Planes, 1, length, 1, 1, 10, 0, false}));
    }
  }
}

TEST(DegenerateFrame, OfOneValidPixelHasNoPlane) {
  RandomFrame frame = flatFrame(40, 30);
  frame.depth.assign(frame.depth.size(), 0.0f);
  inEveryWay(frame, expectNoPlane);
  for (const std::size_t pixel : {0, 39, 615, 1199}) {
    frame.depth.assign(frame.depth.size(), kNaN);
    frame.depth[pixel] = 1.5f;
    inEveryWay(frame, expectNoPlane);
  }
}

// A wall in front of the camera, without any noise.
TEST(DegenerateFrame, OfOneDepthIsOnePlane) {
  for (const FrameKind kind : {FrameKind::Depth, FrameKind::WholeNumbers}) {
    inEveryWay(flatFrame(64, 48, kind), [](const PlaneSegmentation& result, const Way& way) {
      ASSERT_EQ(result.planes.size(), 1U);
      EXPECT_GT(result.planes[0].pixel_count, way.mode == Mode::Paper ? 2700U : 3000U);  // of 3072
      EXPECT_NEAR(result.planes[0].coefficients(2), -1.0, 1e-6);
      EXPECT_NEAR(result.planes[0].coefficients(3), 2.0, 1e-6);
    });
  }
}

TEST(DegenerateFrame, WithoutNoiseIsSound) {
  for (const FrameKind kind :
       {FrameKind::Depth, FrameKind::WholeNumbers, FrameKind::Cloud, FrameKind::BackwardCloud, FrameKind::Scanner})
    for (unsigned seed = 0; seed < 3; ++seed)
      inEveryWay(RandomFrame({kind, Scene::Planes, 60, 45, seed, 3, /* noise */ 0, 0, false}));
}

// All that a cloud has is one point, over and over.
TEST(DegenerateFrame, OfOnePointOverAndOverIsSound) {
  for (const FrameKind kind : {FrameKind::Cloud, FrameKind::BackwardCloud, FrameKind::Scanner}) {
    RandomFrame frame({kind, Scene::Planes, 40, 30, 1, 0, 10, 0, false});
    for (std::size_t i = 0; i < frame.xyz.size(); i += 3) {
      frame.xyz[i] = 0.1f;
      frame.xyz[i + 1] = 0.2f;
      frame.xyz[i + 2] = kind == FrameKind::BackwardCloud ? -2.0f : 2.0f;
    }
    inEveryWay(frame);
    for (std::size_t i = 6; i < frame.xyz.size(); ++i) frame.xyz[i] = frame.xyz[i % 6] + (i % 6 < 3 ? 0.0f : 0.5f);
    inEveryWay(frame);  // two points in turn
  }
}

TEST(DegenerateFrame, OfEveryOtherPixelIsSound) {
  for (const int period : {2, 3, 7})
    for (int phase = 0; phase < 2; ++phase)
      for (const bool by_rows : {false, true}) {
        RandomFrame frame = flatFrame(63, 48);
        for (int i = 0; i < 63 * 48; ++i)
          if (((by_rows ? i / 63 : i) + phase) % period == 0) frame.depth[static_cast<std::size_t>(i)] = kNaN;
        inEveryWay(frame);
      }
}

// 0 and 65535 are nothing, 1 and 65534 are depths.
TEST(DegenerateFrame, OfTheLimitsOf16BitsIsSound) {
  const std::vector<std::uint16_t> limits{0, 65535, 1, 65534, 2, 65533};
  for (const std::uint16_t value : limits) {
    RandomFrame frame = flatFrame(48, 40, FrameKind::WholeNumbers);
    frame.units.assign(frame.units.size(), value);
    inEveryWay(frame, [value](const PlaneSegmentation& result, const Way& way) {
      if (value == 0 || value == 65535) expectNoPlane(result, way);
    });
    for (const std::uint16_t other : limits) {
      for (std::size_t i = 0; i < frame.units.size(); ++i) frame.units[i] = i % 48 < 24 ? value : other;
      inEveryWay(frame);
      for (std::size_t i = 0; i < frame.units.size(); ++i) frame.units[i] = i % 2 == 0 ? value : other;
      inEveryWay(frame);
    }
  }
}

}  // namespace
}  // namespace epcc::test
