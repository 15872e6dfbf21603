// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1 in vector lanes on every real frame: the bits of plain loops, nearly the labels of double precision.
#include <gtest/gtest.h>

#include <iostream>

#include "datasets/sources/native_folder.h"
#include "tests/epcc_segmentation/metric/line_check.h"
#include "tests/support/real_frames.h"

namespace epcc::test {
namespace {

class PaperLines : public ::testing::TestWithParam<const char*> {};

TEST_P(PaperLines, AreTheReferenceToTheBitAndNearlyThatOfDoublePrecision) {
  EPCC_NEED_REAL_FRAMES(GetParam());
  const NativeFolder folder(realFolder(GetParam()));
  ASSERT_GT(folder.size(), 0u);
  std::size_t pixels = 0, different = 0;
  for (std::size_t i = 0; i < folder.size(); ++i) {
    const LabelledFrame frame = folder.read(i);
    SCOPED_TRACE(frame.name);
    const DepthFrame view = DepthFrame::fromDepth(frame.depth.data.data(), frame.camera.camera);
    const auto named = SensorModel::parse(frame.camera.noise.value_or(""));
    const SensorModel sensor = named.value_or(SensorModel::preset("kinect-v1").value());
    expectTheReference(view, {}, sensor);
    const std::vector<int> single = referenceOf(view, {}, sensor).places(view);
    const std::vector<int> precise = preciseReferenceOf(view, sensor).places(view);
    for (std::size_t k = 0; k < single.size(); ++k) different += single[k] != precise[k] ? 1 : 0;
    pixels += single.size();
  }
  std::cout << GetParam() << ": " << different << " of " << pixels << " pixels differ in double precision\n";
  EXPECT_LE(different, pixels / 1000);
}

INSTANTIATE_TEST_SUITE_P(Folders, PaperLines, ::testing::Values("realsense", "kinect", "abw", "icl", "structure"),
                         [](const auto& folder) { return std::string(folder.param); });

}  // namespace
}  // namespace epcc::test
