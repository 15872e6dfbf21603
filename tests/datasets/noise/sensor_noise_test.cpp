// SPDX-License-Identifier: BSD-3-Clause
// White noise after a sensor model, the names of the noises, and seeds.
#include "datasets/noise/sensor_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "datasets/rendered/scene.h"

namespace epcc {
namespace {

// Standard deviation of the depth error in units of sigma_z, by half-metre bin of the true depth.
std::map<int, std::vector<double>> errorsByDepth(const LabelledFrame& clean, const LabelledFrame& noisy,
                                                 const SensorModel& sensor) {
  std::map<int, std::vector<double>> errors;
  for (std::size_t i = 0; i < clean.depth.data.size(); ++i) {
    const double z = static_cast<double>(clean.depth.data[i]);
    errors[static_cast<int>(2.0 * z)].push_back((static_cast<double>(noisy.depth.data[i]) - z) / sensor.sigmaZ(z));
  }
  return errors;
}

TEST(WhiteNoise, FollowsTheModelInEveryDepthBin) {
  const LabelledFrame clean = renderScene("d", 0);
  const auto options = parseNoise("white:d435i");
  LabelledFrame noisy = clean;
  applyNoise(noisy, *options, 0);
  int bins = 0;
  for (const auto& [bin, errors] : errorsByDepth(clean, noisy, *SensorModel::preset("d435i"))) {
    if (errors.size() < 1000) continue;
    ++bins;
    double sum = 0.0, squares = 0.0;
    for (const double error : errors) {
      sum += error;
      squares += error * error;
    }
    const double n = static_cast<double>(errors.size());
    EXPECT_NEAR(sum / n, 0.0, 5.0 / std::sqrt(n)) << bin;
    EXPECT_NEAR(std::sqrt(squares / n), 1.0, 5.0 / std::sqrt(2.0 * n)) << bin;
  }
  EXPECT_GE(bins, 8);
}

TEST(WhiteNoise, DoesNotCorrelateNeighbours) {
  const LabelledFrame clean = renderScene("a", 0);
  LabelledFrame noisy = clean;
  applyNoise(noisy, *parseNoise("white:0.002,0,1"), 4);
  double product = 0.0;
  for (std::size_t i = 1; i < clean.depth.data.size(); ++i)
    product += static_cast<double>((noisy.depth.data[i] - clean.depth.data[i]) *
                                   (noisy.depth.data[i - 1] - clean.depth.data[i - 1]));
  const double n = static_cast<double>(clean.depth.data.size());
  EXPECT_NEAR(product / n / 4e-6, 0.0, 5.0 / std::sqrt(n));
}

TEST(WhiteNoise, LeavesHolesAndLabelsAlone) {
  LabelledFrame clean = renderScene("a", 0);
  clean.depth.data[1000] = 0.0F;
  LabelledFrame noisy = clean;
  applyNoise(noisy, *parseNoise("white:realsense"), 1);
  EXPECT_EQ(noisy.depth.data[1000], 0.0F);
  EXPECT_EQ(noisy.labels.data, clean.labels.data);
}

TEST(Noise, NoneChangesNothing) {
  const LabelledFrame clean = renderScene("b", 0);
  LabelledFrame same = clean;
  applyNoise(same, *parseNoise("none"), 9);
  EXPECT_EQ(same.depth.data, clean.depth.data);
  EXPECT_EQ(*same.camera.noise, "rendered");
}

class EveryNoise : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryNoise, DependsOnTheSeedAlone) {
  const LabelledFrame clean = renderScene("c", 0);
  LabelledFrame first = clean, again = clean, other = clean;
  applyNoise(first, *parseNoise(GetParam()), 1);
  applyNoise(again, *parseNoise(GetParam()), 1);
  applyNoise(other, *parseNoise(GetParam()), 2);
  EXPECT_EQ(first.depth.data, again.depth.data);
  EXPECT_NE(first.depth.data, other.depth.data);
  EXPECT_NE(first.depth.data, clean.depth.data);
}

TEST_P(EveryNoise, DiffersBetweenFramesOfOneSeed) {
  LabelledFrame first = renderScene("c", 0), renamed = first;
  renamed.name = "c_001";
  applyNoise(first, *parseNoise(GetParam()), 1);
  applyNoise(renamed, *parseNoise(GetParam()), 1);
  EXPECT_NE(first.depth.data, renamed.depth.data);
}

TEST_P(EveryNoise, NamesAModelThatSegmentersUnderstand) {
  LabelledFrame frame = renderScene("a", 0);
  applyNoise(frame, *parseNoise(GetParam()), 1);
  EXPECT_TRUE(SensorModel::parse(*frame.camera.noise)) << *frame.camera.noise;
}

INSTANTIATE_TEST_SUITE_P(Noises, EveryNoise,
                         ::testing::Values("white:d435i", "white:0.001,0.002,1", "white:poly:0.007,-0.004,0.001",
                                           "stereo", "stereo-registered"));

TEST(ParseNoise, NamesThePreset) {
  EXPECT_EQ(parseNoise("white:d435i")->preset, "d435i");
  EXPECT_EQ(parseNoise("stereo")->preset, "realsense");
  EXPECT_EQ(parseNoise("stereo-registered")->preset, "realsense-registered");
}

TEST(ParseNoise, SaysWhatIsWrong) {
  for (const char* text : {"", "white", "white:", "white:nothing", "Stereo", "stereo:1", "gauss", "white:1,2"}) {
    std::string why;
    EXPECT_FALSE(parseNoise(text, &why)) << text;
    EXPECT_FALSE(why.empty()) << text;
  }
}

}  // namespace
}  // namespace epcc
