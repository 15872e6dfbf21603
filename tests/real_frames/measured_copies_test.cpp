// SPDX-License-Identifier: BSD-3-Clause
// Copies of half the size, whose pixels are twice as wide as those that a preset counts.
#include <gtest/gtest.h>

#include "datasets/sources/frame_copies.h"
#include "datasets/sources/native_folder.h"
#include "tests/real_frames/scored_frames.h"
#include "tests/support/real_frames.h"

namespace epcc::test {
namespace {

TEST(MeasuredCopies, ThePresetOfTheWholeImageServesHalfOfIt) {
  EPCC_NEED_REAL_FRAMES("kinect");
  const NativeFolder source(realFolder("kinect"));
  long correct = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    LabelledFrame half = copiedFrame(source.read(i), FrameCopy::HalfResolution);
    half.camera.noise = "kinect-v1";  // a copy says that its length is half of it
    correct += scoreFrame(half, Parameters()).segcomp.correct;
  }
  EXPECT_GE(correct, 58) << "of 80; 44 by a length that is twice too long";
}

}  // namespace
}  // namespace epcc::test
