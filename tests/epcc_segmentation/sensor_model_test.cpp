// SPDX-License-Identifier: BSD-3-Clause
// Presets, forms and the command-line syntax of the sensor model.
#include "epcc_segmentation/sensor_model.h"

#include <gtest/gtest.h>

namespace {

using epcc::SensorModel;

TEST(SensorModel, D435iIsEquation22) {
  const SensorModel model = *SensorModel::preset("d435i");
  for (const double z : {0.3, 1.0, 2.5, 4.9, 8.0})
    EXPECT_NEAR(model.sigmaZ(z), 0.006954 * z * z - 0.003713 * z + 0.001153, 1e-15);
  EXPECT_NEAR(model.sigmaZ(4.9), 0.15, 0.002);  // where the printed Eq. 27 would forbid every start
  EXPECT_EQ(model.correlationLength(), 2.0);
}

TEST(SensorModel, AxialFormIsTheQuadraticSum) {
  const SensorModel model = SensorModel::axial(0.0035, 0.0055, 6.0);
  EXPECT_NEAR(model.sigmaZ(2.0), std::sqrt(0.0035 * 0.0035 + 0.022 * 0.022), 1e-15);
  EXPECT_NEAR(model.sigmaInverseDepth(2.0), model.sigmaZ(2.0) / 4.0, 1e-15);
  EXPECT_NEAR(model.pixelsPerSample(), 2.0 * M_PI * 36.0, 1e-9);
  EXPECT_NEAR(model.pixelsPerLineSample(), 15.0, 1e-12);
  EXPECT_EQ(SensorModel::axial(0.001, 0.0, 0.1).pixelsPerSample(), 1.0);
}

TEST(SensorModel, VarianceIsTheSquareOfSigma) {
  for (const SensorModel& model : {SensorModel::axial(0.0035, 0.0055), *SensorModel::preset("d435i"),
                                   SensorModel::axial(0.0, 1e-9), SensorModel::polynomial(0.0, 0.01, -0.005)})
    for (const double z : {0.1, 1.0, 2.5, 8.0})
      EXPECT_NEAR(model.varianceZ(z) / (model.sigmaZ(z) * model.sigmaZ(z)), 1.0, 1e-12) << model.description();
}

TEST(SensorModel, EveryPresetIsKnownAndValid) {
  EXPECT_EQ(SensorModel::presetNames().size(), 7u);
  for (const auto& name : SensorModel::presetNames()) {
    ASSERT_TRUE(SensorModel::preset(name).has_value()) << name;
    EXPECT_EQ(SensorModel::preset(name)->validate(), "") << name;
    EXPECT_EQ(SensorModel::parse(name)->description(), SensorModel::preset(name)->description());
  }
  EXPECT_FALSE(SensorModel::preset("kinect-v9").has_value());
}

TEST(SensorModel, ParsesNumbers) {
  EXPECT_EQ(SensorModel::parse("0.0035,0.0055,6")->description(), SensorModel::axial(0.0035, 0.0055, 6).description());
  EXPECT_NEAR(SensorModel::parse("poly:0.006954,-0.003713,0.001153")->sigmaZ(2.0),
              SensorModel::preset("d435i")->sigmaZ(2.0), 1e-15);
}

TEST(SensorModel, TheCorrelatedShareIsAFourthNumberAndStaysWithTheModel) {
  EXPECT_EQ(SensorModel::parse("0.01,0,1")->correlatedShare(), 1.0);
  const SensorModel model = SensorModel::parse("0.01,0,1,0.25").value();
  EXPECT_EQ(model.correlatedShare(), 0.25);
  EXPECT_EQ(model.description(), "axial a=0.01 m b=0 1/m l=1 px c=0.25");
  EXPECT_EQ(model.scaled(2.0).withCorrelationLength(3.0).correlatedShare(), 0.25);
  for (const double share : {-0.1, 1.1, std::nan("")})
    EXPECT_EQ(model.withCorrelatedShare(share).validate(), "the correlated share must be in [0, 1]") << share;
  for (const double share : {0.0, 1.0}) EXPECT_EQ(model.withCorrelatedShare(share).validate(), "") << share;
}

TEST(SensorModel, ParseSaysWhatIsWrong) {
  for (const char* bad : {"", "nonsense", "1,2", "1,2,3,4", "1,2,x", "nan,0,1", "0.001,inf,1", "-0.001,0,1", "0,0,1",
                          "0.001,0,-1", "poly:", "poly:-1,0,0", "poly:0,0,0", "0.001,0,5000", "0.001,0,1 ",
                          "0.001,0,1,-0.1", "0.001,0,1,nan", "0.001,0,1,1,1", "poly:0.001,0,0.1,1"}) {
    std::string why;
    EXPECT_FALSE(SensorModel::parse(bad, &why).has_value()) << bad;
    EXPECT_FALSE(why.empty()) << bad;
  }
}

TEST(SensorModel, IsParsedToItsEnd) {
  EXPECT_FALSE(SensorModel::parse(std::string("0.1,0.2,1\0 and more", 18)).has_value());
  EXPECT_FALSE(SensorModel::parse("0.1,0.2,1,").has_value());
  EXPECT_FALSE(SensorModel::parse("0.1,0.2").has_value());
  EXPECT_TRUE(SensorModel::parse("0.1, 0.2, +1").has_value());
}

TEST(SensorModel, SigmaIsNeverZero) {
  EXPECT_GT(SensorModel::polynomial(1.0, -2.0, 0.5).sigmaZ(1.0), 0.0);
}

}  // namespace
