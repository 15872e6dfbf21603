// SPDX-License-Identifier: BSD-3-Clause
// Every frame that can be had gives a sound result, in every way to segment it.
#include "tests/epcc_segmentation/properties/sound_result.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "epcc_segmentation/sensor_estimation.h"

namespace epcc::test {
namespace {

void expectSound(const RandomFrame& frame, const Way& way) {
  Parameters parameters = way.parameters();
  parameters.line_segments = true;
  PlaneExtractor extractor(parameters, way.sensor(frame.sensor()));
  PlaneSegmentation result;
  (void)extractor.extract(frame.frame(), result);
  RC_ASSERT(extractor.error() == "");
  RC_ASSERT(resultProblem(result, frame) == "");
  RC_ASSERT(std::isfinite(result.doubts.error_share));
  RC_ASSERT(extractor.sensor().validate() == "");
}

RC_GTEST_PROP(SoundResult, OfEveryFrameInEveryWay, ()) {
  const FrameSpec spec = *anyFrame();
  expectSound(RandomFrame(spec), *anyWay(spec.kind));
}

RC_GTEST_PROP(SoundResult, OfPlanesSeenByCamerasAndScanners, ()) {
  const FrameSpec spec = *planarFrame(
      {FrameKind::Depth, FrameKind::WholeNumbers, FrameKind::Cloud, FrameKind::BackwardCloud, FrameKind::Scanner});
  const Way way = *anyWay(spec.kind);
  expectSound(RandomFrame(spec), way);
}

// What the generators make has planes to be found: without it the properties would hold of nothing.
TEST(SoundResult, TheRandomFramesHavePlanes) {
  for (const FrameKind kind :
       {FrameKind::Depth, FrameKind::WholeNumbers, FrameKind::Cloud, FrameKind::BackwardCloud, FrameKind::Scanner})
    for (const Mode mode : {Mode::InverseDepth, Mode::Paper}) {
      std::size_t planes = 0;
      for (unsigned seed = 0; seed < 20; ++seed) {
        const RandomFrame frame({kind, Scene::Planes, 100, 75, seed, 4, 10, 5, false});
        Way way;
        way.mode = mode;
        PlaneSegmentation result;
        ASSERT_TRUE(PlaneExtractor(way.parameters(), frame.sensor()).extract(frame.frame(), result));
        planes += result.planes.size();
      }
      EXPECT_GE(planes, 40U) << static_cast<int>(kind) << ' ' << static_cast<int>(mode);
    }
}

RC_GTEST_PROP(SoundSensor, IsMeasuredOnEveryFrame, ()) {
  const RandomFrame frame(*anyFrame());
  const SensorEstimate estimate = estimateSensor(frame.frame());
  RC_ASSERT(estimate.model().validate() == "");
  for (const double z : {1e-3, 0.5, 3.0, 60.0}) RC_ASSERT(estimate.model().varianceZ(z) > 0.0);
  RC_ASSERT(estimate.blotch_share >= 0.0 && estimate.blotch_share <= 1.0);
  RC_ASSERT(estimate.correlated_share >= 0.0 && estimate.correlated_share <= 1.0);
}

RC_GTEST_PROP(SoundSensor, HasAVarianceAboveZeroAtEveryDepth, ()) {
  const auto number = rc::gen::map(rc::gen::inRange(-100000, 1000000), [](int i) { return 1e-3 * i; });
  const auto power = rc::gen::map(rc::gen::inRange(-320, 120), [](int i) { return std::pow(10.0, 0.1 * i); });
  const bool is_axial = *rc::gen::arbitrary<bool>();
  const double k1 = *number, k2 = *number, k3 = *number, length = std::min(1000.0, *power);
  const SensorModel model = is_axial ? SensorModel::axial(std::abs(k1), std::abs(k2), length)
                                     : SensorModel::polynomial(std::abs(k1), k2, k3, length);
  RC_PRE(model.validate() == "");
  const double z = *power;
  RC_ASSERT(std::isfinite(model.varianceZ(z)));
  RC_ASSERT(model.varianceZ(z) > 0.0);
  RC_ASSERT(model.sigmaInverseDepth(z) > 0.0);
  RC_ASSERT(model.pixelsPerSample() >= 1.0 && model.pixelsPerLineSample() >= 1.0);
}

}  // namespace
}  // namespace epcc::test
