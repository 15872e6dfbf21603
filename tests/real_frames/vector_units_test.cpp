// SPDX-License-Identifier: BSD-3-Clause
// Every vector unit gives the same labels and the same planes, to the bit, on every labelled frame.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "datasets/noise/sensor_noise.h"
#include "datasets/rendered/scene.h"
#include "datasets/sources/dataset_registry.h"
#include "epcc_segmentation/plane_extractor.h"
#include "tests/support/real_frames.h"
#include "tests/support/vector_units.h"

namespace epcc::test {
namespace {

void expectSamePlane(const Plane& plane, const Plane& first) {
  EXPECT_EQ(plane.coefficients, first.coefficients);
  EXPECT_EQ(plane.coefficients_covariance, first.coefficients_covariance);
  EXPECT_EQ(plane.centroid, first.centroid);
  EXPECT_EQ(plane.points_covariance, first.points_covariance);
  EXPECT_EQ(plane.rms, first.rms);
  EXPECT_EQ(plane.pixel_count, first.pixel_count);
}

/// Without a sensor it is measured.
void expectTheSameOnEveryUnit(const DepthFrame& frame, const Parameters& parameters,
                              const std::optional<SensorModel>& sensor) {
  PlaneSegmentation first;
  onEveryVectorUnit([&] {
    PlaneExtractor extractor(parameters, sensor);
    PlaneSegmentation result;
    ASSERT_TRUE(extractor.extract(frame, result)) << extractor.error();
    if (first.labels.empty()) first = result;
    EXPECT_TRUE(result.labels == first.labels);  // not printed
    ASSERT_EQ(result.planes.size(), first.planes.size());
    for (std::size_t k = 0; k < first.planes.size(); ++k) expectSamePlane(result.planes[k], first.planes[k]);
  });
  EXPECT_FALSE(first.planes.empty());
}

void expectTheSameOnEveryUnit(const LabelledFrame& frame) {
  SCOPED_TRACE(frame.name);
  const DepthFrame view = frameView(frame);
  const std::string noise = frame.camera.noise.value_or("");
  const auto named = SensorModel::parse(noise.empty() ? "kinect-v1" : noise);
  ASSERT_TRUE(named.has_value()) << noise;
  for (const Parameters& parameters : {Parameters(), Parameters::forPaper()})
    expectTheSameOnEveryUnit(view, parameters, named);
  expectTheSameOnEveryUnit(view, Parameters(), std::nullopt);
}

class VectorUnitsAgree : public ::testing::TestWithParam<const char*> {};

TEST_P(VectorUnitsAgree, OnEveryLabelledFrame) {
  EPCC_NEED_REAL_FRAMES(GetParam());
  const auto frames = openDataset(realFolder(GetParam()));
  std::size_t labelled = 0;
  for (std::size_t i = 0; i < frames->size(); ++i) {
    const LabelledFrame frame = frames->read(i);
    if (frame.labels.empty()) continue;
    ++labelled;
    expectTheSameOnEveryUnit(frame);
  }
  EXPECT_GT(labelled, 0u);
}

INSTANTIATE_TEST_SUITE_P(Folders, VectorUnitsAgree,
                         ::testing::Values("realsense", "kinect", "abw", "icl", "structure", "sensors", "synpeb"),
                         [](const auto& folder) { return std::string(folder.param); });

TEST(VectorUnits, AgreeOnRenderedScenes) {
  for (const std::string& scene : sceneNames())
    for (const char* noise : {"none", "white:d435i", "stereo"}) {
      SCOPED_TRACE(noise);
      LabelledFrame frame = renderScene(scene, 0);
      applyNoise(frame, parseNoise(noise).value(), 1);
      expectTheSameOnEveryUnit(frame);
    }
}

}  // namespace
}  // namespace epcc::test
