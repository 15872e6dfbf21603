// SPDX-License-Identifier: BSD-3-Clause
// The measuring of noise on planes with known noise, and the stereo noise beside the real frames.
#include "datasets/noise/noise_measurement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "datasets/noise/sensor_noise.h"
#include "datasets/rendered/scene.h"
#include "datasets/rendered/scene_renderer.h"
#include "tests/support/real_frames.h"

namespace epcc {
namespace {

LabelledFrame wallFrame(double z) {
  LabelledFrame frame;
  frame.camera.camera = sceneCamera();
  frame.depth = renderPlane({0.0, -0.28, -0.96, 0.96 * z}, frame.camera.camera);
  frame.labels = LabelImage(frame.depth.width, frame.depth.height, 1);
  return frame;
}

TEST(MeasureNoise, FindsWhiteNoiseOfKnownSize) {
  LabelledFrame frame = wallFrame(1.2);
  applyNoise(frame, *parseNoise("white:0.01,0,1"), 1);
  const NoiseFigures figures = measureNoise({frame});
  EXPECT_EQ(figures.planes, 1);
  // Bin 1.0-1.4 m; axial over sqrt(1 + tan^2), tan = 0.29 at the image's centre; gate at 3 sigma takes 1.3 %.
  EXPECT_NEAR(figures.rms[4], 0.01 / std::hypot(1.0, 0.29) * 0.987, 0.0004);
  EXPECT_NEAR(figures.along_rows[0], 0.0, 0.02);
  EXPECT_NEAR(figures.along_columns[2], 0.0, 0.02);
}

TEST(MeasureNoise, IsUnmovedByOutliersAndCountsThem) {
  LabelledFrame frame = wallFrame(1.2);
  applyNoise(frame, *parseNoise("white:0.002,0,1"), 1);
  for (std::size_t i = 0; i < frame.depth.data.size(); i += 20) frame.depth.data[i] *= 1.1F;
  const NoiseFigures figures = measureNoise({frame});
  EXPECT_NEAR(figures.rms[4], 0.002 / std::hypot(1.0, 0.29), 0.0002);
  EXPECT_NEAR(figures.outlier_share, 0.05, 0.006);
}

TEST(MeasureNoise, LeavesOutSmallPlanesAndIgnoredPixels) {
  LabelledFrame frame = wallFrame(1.2);
  for (std::size_t i = 0; i < frame.labels.data.size(); ++i)
    frame.labels.data[i] = i < 500 ? 1 : i < 2000 ? 0 : kIgnoreLabel;
  EXPECT_EQ(measureNoise({frame}).planes, 0);
}

TEST(Flattened, IsExactWhereThePlaneIs) {
  const LabelledFrame clean = wallFrame(1.0);
  LabelledFrame noisy = clean;
  applyNoise(noisy, *parseNoise("white:0.002,0,1"), 1);
  for (std::size_t i = 0; i < 480 * 100; ++i) noisy.labels.data[i] = 0;
  const LabelledFrame flat = flattened(noisy);
  EXPECT_EQ(flat.depth.data[100], 0.0F);
  for (std::size_t i = 480 * 100; i < flat.depth.data.size(); ++i)
    ASSERT_NEAR(flat.depth.data[i], clean.depth.data[i], 3e-4F);
}

// Registered frames: stereo noise on the planes fitted to the real frames, both measured the same way.
TEST(StereoNoise, AgreesWithRealFramesInSizeAndCorrelation) {
  EPCC_NEED_REAL_FRAMES("realsense");
  std::vector<LabelledFrame> real, rendered;
  for (const std::string& name : listLabelledFrames(test::realFolder("realsense"))) {
    LabelledFrame frame = readLabelledFrame(test::realFolder("realsense"), name);
    if (frame.camera.noise != "realsense-registered") continue;
    rendered.push_back(flattened(frame));
    applyNoise(rendered.back(), *parseNoise("stereo-registered"), rendered.size());
    real.push_back(std::move(frame));
  }
  ASSERT_GE(real.size(), 6U);
  const NoiseFigures r = measureNoise(real), s = measureNoise(rendered);
  for (std::size_t bin = 0; bin < r.rms.size(); ++bin) {
    ASSERT_GT(r.pixels[bin], 10000) << bin;
    EXPECT_GT(s.rms[bin], 0.65 * r.rms[bin]) << bin;
    EXPECT_LT(s.rms[bin], 1.55 * r.rms[bin]) << bin;
  }
  for (std::size_t k = 0; k < kNoiseLags.size(); ++k) {
    EXPECT_NEAR(s.along_rows[k], r.along_rows[k], 0.2) << kNoiseLags[k];
    EXPECT_NEAR(s.along_columns[k], r.along_columns[k], 0.2) << kNoiseLags[k];
  }
}

}  // namespace
}  // namespace epcc
