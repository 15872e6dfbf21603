// SPDX-License-Identifier: BSD-3-Clause
// The sensor measured on a copy of half the size is that of the original, in pixels that are twice as wide.
#include <gtest/gtest.h>

#include "datasets/sources/frame_copies.h"
#include "datasets/sources/native_folder.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "tests/real_frames/scored_frames.h"
#include "tests/support/real_frames.h"

namespace epcc::test {
namespace {

TEST(MeasuredCopies, HalfTheSizeHasTheSameErrorOfHalfTheLength) {
  EPCC_NEED_REAL_FRAMES("kinect");
  const NativeFolder source(realFolder("kinect"));
  for (std::size_t i = 0; i < source.size(); ++i) {
    const LabelledFrame frame = source.read(i), half = copiedFrame(frame, FrameCopy::HalfResolution);
    SCOPED_TRACE(frame.name);
    const SensorModel whole_model = estimateSensor(frameView(frame)).model();
    const SensorModel half_model = estimateSensor(frameView(half)).model();
    for (const double z : {1.0, 2.0, 3.0}) {
      const double ratio = half_model.sigmaZ(z) / whole_model.sigmaZ(z);
      EXPECT_GT(ratio, 0.75) << z;
      EXPECT_LT(ratio, 1.35) << z;
    }
    const double shorter = half_model.correlationLength() / whole_model.correlationLength();
    EXPECT_GT(shorter, 0.45);
    EXPECT_LT(shorter, 0.65);
  }
}

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
