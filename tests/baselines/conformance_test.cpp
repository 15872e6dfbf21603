// SPDX-License-Identifier: BSD-3-Clause
// What the interface promises, checked on every method of the registry with the same cases.
#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <set>

#include "baselines/registry.h"
#include "datasets/files/labelled_frame.h"
#include "tests/baselines/baseline_frames.h"
#include "tests/support/real_frames.h"

namespace epcc::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

class Conformance : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<PlaneSegmenter> segmenter_ = makeSegmenter(GetParam());
  PlaneSegmentation result_;

  /// A result that a failing or planeless call has to overwrite.
  void soilResult() { result_ = {3, 1, {1, 2, 7}, std::vector<Plane>(7), std::vector<LineSegment>(2), {}}; }

  /// Success and an error in words exclude each other.
  void segmentAndCheckStatus(const SegmenterInput& input) {
    const bool done = segmenter_->segment(input, result_);
    EXPECT_EQ(done, segmenter_->error().empty()) << segmenter_->error();
  }

  /// Success without planes, or an error in words; either way a clean result of the frame's size.
  void expectNoPlanes(const DepthFrame& frame) {
    soilResult();
    segmentAndCheckStatus({frame, mildSensor(), "frame"});
    EXPECT_TRUE(result_.planes.empty());
    EXPECT_EQ(result_.width, frame.width());
    EXPECT_EQ(result_.height, frame.height());
    EXPECT_EQ(result_.labels, std::vector<std::int32_t>(result_.labels.size(), 0));
    EXPECT_EQ(result_.labels.size(), static_cast<std::size_t>(frame.width() * frame.height()));
  }

  /// Labels, planes and pixel counts agree; no label without a measurement.
  void expectConsistent(const DepthFrame& frame) {
    ASSERT_EQ(result_.labels.size(), static_cast<std::size_t>(frame.width() * frame.height()));
    std::vector<std::size_t> counts(result_.planes.size() + 1, 0);
    Eigen::Vector3d point;
    for (int row = 0; row < frame.height(); ++row)
      for (int column = 0; column < frame.width(); ++column) {
        const std::int32_t label = result_.labels[frame.index(row, column)];
        ASSERT_GE(label, 0);
        ASSERT_LE(label, static_cast<std::int32_t>(result_.planes.size()));
        if (label > 0) {
          ASSERT_TRUE(frame.point(row, column, point)) << "row " << row << " column " << column;
        }
        ++counts[static_cast<std::size_t>(label)];
      }
    for (std::size_t i = 0; i < result_.planes.size(); ++i) {
      const Plane& plane = result_.planes[i];
      EXPECT_GT(counts[i + 1], 0u);
      EXPECT_EQ(plane.pixel_count, counts[i + 1]);
      EXPECT_NEAR(plane.coefficients.head<3>().norm(), 1.0, 1e-9);
      EXPECT_GE(plane.coefficients(3), 0.0);
      if (i > 0) {
        EXPECT_LE(plane.pixel_count, result_.planes[i - 1].pixel_count);
      }
    }
  }
};

TEST_P(Conformance, FindsThreePlanesOfARoom) {
  const RenderedRoom room = noisyRoom();
  ASSERT_TRUE(segmenter_->segment(inputOf(room), result_)) << segmenter_->error();
  expectConsistent(room.frame());
  for (std::int32_t truth = 1; truth <= 3; ++truth)
    EXPECT_GE(bestCoverage(room, result_, truth), 0.7) << "true plane " << truth;
  ASSERT_GE(result_.planes.size(), 3u);
  // The three largest are the three true planes.
  const auto truth = cornerPlanes();
  std::set<std::size_t> found;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t t = 0; t < truth.size(); ++t)
      if ((result_.planes[i].coefficients - truth[t]).norm() < 0.05) found.insert(t);
  EXPECT_EQ(found.size(), 3u);
}

TEST_P(Conformance, FindsThemInAnOrganizedCloudToo) {
  const RenderedRoom room = noisyRoom();
  std::vector<float> xyz;
  Eigen::Vector3d point;
  for (int row = 0; row < room.camera.height; ++row)
    for (int column = 0; column < room.camera.width; ++column) {
      ASSERT_TRUE(room.frame().point(row, column, point));
      for (int axis = 0; axis < 3; ++axis) xyz.push_back(static_cast<float>(point(axis)));
    }
  const DepthFrame cloud =
      DepthFrame::fromPoints(xyz.data(), 3, room.camera.width, room.camera.height, Projection::Perspective);
  ASSERT_TRUE(segmenter_->segment({cloud, mildSensor(), "cloud"}, result_)) << segmenter_->error();
  expectConsistent(cloud);
  for (std::int32_t truth = 1; truth <= 3; ++truth)
    EXPECT_GE(bestCoverage(room, result_, truth), 0.7) << "true plane " << truth;
}

TEST_P(Conformance, LeavesUnmeasuredPixelsAlone) {
  RenderedRoom room = noisyRoom();
  const float bad[] = {kNan, 0.0f, -1.0f, kInf, -kInf};
  for (std::size_t i = 0; i < room.depth.size(); i += 7919) room.depth[i] = bad[i % 5];
  for (int row = 100; row < 130; ++row)
    for (int column = 60; column < 100; ++column)
      room.depth[static_cast<std::size_t>(row * 320 + column)] = bad[(row + column) % 5];
  std::vector<std::uint8_t> mask(room.depth.size(), 1);
  for (std::size_t i = 0; i < mask.size() / 4; ++i) mask[i] = 0;
  const DepthFrame frame = room.frame().masked(mask.data());
  ASSERT_TRUE(segmenter_->segment({frame, mildSensor(), "holes"}, result_)) << segmenter_->error();
  EXPECT_FALSE(result_.planes.empty());
  expectConsistent(frame);
}

TEST_P(Conformance, RepeatsItsResult) {
  const RenderedRoom room = noisyRoom();
  const RenderedRoom other = renderRoom(cornerPlanes(), testCamera(160, 120));
  PlaneSegmentation again, in_between, fresh;
  ASSERT_TRUE(segmenter_->segment(inputOf(room), result_));
  ASSERT_TRUE(segmenter_->segment(inputOf(other), in_between));
  ASSERT_TRUE(segmenter_->segment(inputOf(room), again));
  ASSERT_TRUE(makeSegmenter(GetParam())->segment(inputOf(room), fresh));
  EXPECT_EQ(in_between.labels.size(), 160u * 120u);
  EXPECT_EQ(result_.labels, again.labels);
  EXPECT_EQ(result_.labels, fresh.labels);
  ASSERT_EQ(result_.planes.size(), fresh.planes.size());
  for (std::size_t i = 0; i < fresh.planes.size(); ++i)
    EXPECT_EQ(result_.planes[i].coefficients, fresh.planes[i].coefficients);
}

TEST_P(Conformance, FollowsATransposedView) {
  const RenderedRoom room = noisyRoom();
  const DepthFrame turned = room.frame().transposed();
  ASSERT_TRUE(segmenter_->segment({turned, mildSensor(), "turned"}, result_)) << segmenter_->error();
  expectConsistent(turned);
  for (std::int32_t truth = 1; truth <= 3; ++truth)
    EXPECT_GE(bestCoverage(room, result_, truth), 0.7) << "true plane " << truth;
}

TEST_P(Conformance, FrameWithoutMeasurementHasNoPlanes) {
  for (const float value : {0.0f, -1.0f, kNan, kInf}) {
    const std::vector<float> depth(64 * 48, value);
    expectNoPlanes(DepthFrame::fromDepth(depth.data(), testCamera(64, 48)));
    EXPECT_EQ(segmenter_->error(), "");
  }
}

TEST_P(Conformance, OneRowOrColumnHasNoPlanes) {
  const std::vector<float> depth(640, 1.0f);
  expectNoPlanes(DepthFrame::fromDepth(depth.data(), testCamera(640, 1)));
  EXPECT_EQ(segmenter_->error(), "");
  PinholeCamera column{1, 640, 384.0, 384.0, 0.0, 319.5};
  expectNoPlanes(DepthFrame::fromDepth(depth.data(), column));
  EXPECT_EQ(segmenter_->error(), "");
}

TEST_P(Conformance, TinyFramesHaveNoPlanes) {
  const std::vector<float> depth(64, 1.0f);
  for (const auto& size : {std::pair<int, int>{1, 1}, {2, 1}, {2, 2}, {2, 5}, {3, 3}, {7, 2}, {4, 4}, {5, 5}})
    expectNoPlanes(DepthFrame::fromDepth(depth.data(), testCamera(size.first, size.second)));
}

TEST_P(Conformance, SmallFramesDoNotCrash) {
  const std::vector<float> depth(25 * 25, 1.0f);
  for (int width = 6; width <= 25; width += 3)
    for (int height = 6; height <= 25; height += 4) {
      const DepthFrame frame = DepthFrame::fromDepth(depth.data(), testCamera(width, height));
      segmentAndCheckStatus({frame, mildSensor(), ""});
      expectConsistent(frame);
    }
}

TEST_P(Conformance, DuplicatedPointsDoNotCrash) {
  std::vector<float> xyz;
  for (int i = 0; i < 64 * 64; ++i) xyz.insert(xyz.end(), {0.1f, 0.2f, 1.0f});
  const DepthFrame frame = DepthFrame::fromPoints(xyz.data(), 3, 64, 64, Projection::Perspective);
  soilResult();
  segmentAndCheckStatus({frame, mildSensor(), ""});
  expectConsistent(frame);
}

TEST_P(Conformance, HugeCoordinatesDoNotCrash) {
  for (const float far : {1e5f, 1e12f, 1e30f, 3e38f}) {
    RenderedRoom room = noisyRoom();
    for (std::size_t i = 0; i < room.depth.size(); i += 11) room.depth[i] = far;
    segmentAndCheckStatus(inputOf(room));
    expectConsistent(room.frame());
    for (float& z : room.depth) z = far;
    segmentAndCheckStatus(inputOf(room));
    expectConsistent(room.frame());
  }
}

TEST_P(Conformance, SphericalScansKeepTheContract) {
  // A sensor in the middle of a closed box, looking all around.
  const int width = 360, height = 90;
  std::vector<float> xyz;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const double azimuth = M_PI - 2.0 * M_PI * column / width, elevation = 0.7 - 1.4 * row / height;
      const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                std::sin(elevation));
      const Eigen::Array3d half(3.0, 2.5, 1.2);
      const Eigen::Vector3d p = ray * (half / ray.array().abs().max(1e-9)).minCoeff();
      for (int axis = 0; axis < 3; ++axis) xyz.push_back(static_cast<float>(p(axis)));
    }
  const DepthFrame frame = DepthFrame::fromPoints(xyz.data(), 3, width, height, Projection::Spherical);
  ASSERT_TRUE(segmenter_->segment({frame, mildSensor(), "scan"}, result_)) << segmenter_->error();
  EXPECT_FALSE(result_.planes.empty());
  expectConsistent(frame);
}

TEST_P(Conformance, FailureClearsTheResult) {
  soilResult();
  EXPECT_FALSE(segmenter_->segment({DepthFrame::fromDepth(nullptr, testCamera()), mildSensor(), ""}, result_));
  EXPECT_FALSE(segmenter_->error().empty());
  EXPECT_TRUE(result_.labels.empty());
  EXPECT_TRUE(result_.planes.empty());

  const RenderedRoom room = noisyRoom();
  soilResult();
  EXPECT_FALSE(segmenter_->segment({room.frame(), SensorModel::axial(-1.0, 0.0), ""}, result_));
  EXPECT_FALSE(segmenter_->error().empty());
  EXPECT_EQ(result_.labels, std::vector<std::int32_t>(320 * 240, 0));
  EXPECT_TRUE(result_.planes.empty());

  EXPECT_TRUE(segmenter_->segment(inputOf(room), result_));
  EXPECT_EQ(segmenter_->error(), "");
}

TEST_P(Conformance, TellsItsTimeAndName) {
  const RenderedRoom room = noisyRoom();
  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE(segmenter_->segment(inputOf(room), result_));
  const double outside = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_GT(segmenter_->seconds(), 1e-5);
  // EPCC reads the frame and fits the planes itself; the others' time is without either.
  const bool is_epcc = GetParam().rfind("epcc", 0) == 0;
  EXPECT_EQ(segmenter_->conversionSeconds() > 0.0, !is_epcc);
  EXPECT_EQ(segmenter_->fitSeconds() > 0.0, !is_epcc);
  EXPECT_LE(segmenter_->seconds() + segmenter_->conversionSeconds() + segmenter_->fitSeconds(), outside);
  EXPECT_EQ(segmenter_->name(), GetParam());
}

TEST_P(Conformance, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const RenderedRoom room = noisyRoom();
  segmenter_->segment(inputOf(room), result_);
  RenderedRoom far = room;
  far.depth[5] = 1e30f;
  segmenter_->segment(inputOf(far), result_);
  const std::vector<float> depth(64 * 48, 1.0f);
  segmenter_->segment({DepthFrame::fromDepth(depth.data(), testCamera(64, 48)), mildSensor(), ""}, result_);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_P(Conformance, TakesARealKinectFrame) {
  EPCC_NEED_REAL_FRAMES("kinect");
  const LabelledFrame real = readLabelledFrame(realFolder("kinect"), "mosd_learn12");
  const DepthFrame frame = DepthFrame::fromDepth(real.depth.data.data(), real.camera.camera);
  ASSERT_TRUE(segmenter_->segment({frame, *SensorModel::preset("kinect-v1"), real.name}, result_))
      << segmenter_->error();
  EXPECT_FALSE(result_.planes.empty());
  expectConsistent(frame);
}

INSTANTIATE_TEST_SUITE_P(EverySegmenter, Conformance, testing::ValuesIn(segmenterNames()),
                         [](const testing::TestParamInfo<std::string>& method) {
                           std::string name = method.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace epcc::test
