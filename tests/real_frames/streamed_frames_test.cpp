// SPDX-License-Identifier: BSD-3-Clause
// Every real frame as a stream of its columns, and of its rows, against the same frame whole.
#include <gtest/gtest.h>

#include "datasets/files/organized_pcd.h"
#include "datasets/sources/native_folder.h"
#include "tests/support/real_frames.h"
#include "tests/support/streamed_frame.h"

namespace epcc::test {
namespace {

class StreamedFrames : public ::testing::TestWithParam<const char*> {};

TEST_P(StreamedFrames, AreTheFramesSegmentedWhole) {
  EPCC_NEED_REAL_FRAMES(GetParam());
  const NativeFolder folder(realFolder(GetParam()));
  ASSERT_GT(folder.size(), 0u);
  for (std::size_t i = 0; i < folder.size(); ++i) {
    const LabelledFrame frame = folder.read(i);
    SCOPED_TRACE(frame.name);
    const float* depth = frame.depth.data.data();
    const PinholeCamera& camera = frame.camera.camera;
    StreamOptions options;
    options.sensor = SensorModel::parse(frame.camera.noise.value_or(""));
    if (!options.sensor) options.sensor = SensorModel::preset("kinect-v1");
    options.lines_at_once = i % 2 == 0 ? 32 : 5;
    expectTheWholeFrame(DepthFrame::fromDepth(depth, camera), depth, camera, i % 4 == 3, options);
  }
}

INSTANTIATE_TEST_SUITE_P(Folders, StreamedFrames, ::testing::Values("realsense", "kinect", "abw", "icl", "structure"),
                         [](const auto& folder) { return std::string(folder.param); });

TEST(StreamedClouds, OfScannersAreTheCloudsSegmentedWhole) {
  EPCC_NEED_REAL_FRAMES("synpeb");
  for (const char* name : {"pc_01", "test_100", "test_500"}) {
    SCOPED_TRACE(name);
    const auto cloud = readOrganizedPcd(realFolder("synpeb") + "/" + name + ".pcd");
    StreamOptions options;
    options.sensor = SensorModel::axial(0.01, 0.0);
    expectTheWholeCloud(cloud.xyz.data(), 3, cloud.width, cloud.height, Projection::Spherical, options, 6);
  }
}

TEST(StreamedClouds, OfACameraAreTheCloudsSegmentedWhole) {
  EPCC_NEED_REAL_FRAMES("kinect");
  for (const char* name : {"mosd_learn0", "pcl_capture0001"}) {
    SCOPED_TRACE(name);
    const auto cloud = readOrganizedPcd(realFolder("kinect") + "/" + name + ".pcd");
    StreamOptions options;
    options.sensor = SensorModel::preset("kinect-v1");
    expectTheWholeCloud(cloud.xyz.data(), 3, cloud.width, cloud.height, Projection::Perspective, options, 3);
  }
}

}  // namespace
}  // namespace epcc::test
