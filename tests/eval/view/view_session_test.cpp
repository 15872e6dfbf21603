// SPDX-License-Identifier: BSD-3-Clause
// Keys change what is shown, and the texts say so.
#include "eval/view/view_session.h"

#include <gtest/gtest.h>

#include <random>

#include "eval/view/view_text.h"
#include "tests/eval/view/need_surfaces.h"
#include "tests/eval/view/session_frames.h"

namespace epcc {
namespace {

using C = ViewCommand;

class ViewSessionTest : public ::testing::Test {
 protected:
  static ViewSession session(const SegmentOptions& options = {}) { return {options, test::roomInputs()}; }
  static void press(ViewSession& session, C command, int times) {
    for (int i = 0; i < times; ++i) session.press(command);
  }
  static bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }
};

TEST_F(ViewSessionTest, StartsWithTheFirstInputSegmented) {
  const ViewSession shown = session();
  EXPECT_EQ(shown.problem(), "");
  EXPECT_EQ(shown.result().planes.size(), 3U);
  EXPECT_EQ(shown.scene().points.size(), 80U * 60U);
  EXPECT_EQ(shown.place(), ViewPlace::Sensor);
  const ViewTexts texts = viewTexts(shown);
  EXPECT_EQ(texts.top.rfind("[1/3] room0\n80x60, 3 planes, ", 0), 0U) << texts.top;
  EXPECT_TRUE(has(texts.top, "sensor 0.0005,0.0005,1, mode inverse-depth")) << texts.top;
  EXPECT_TRUE(has(texts.top, "> line_k_max        1.5 sigma_w")) << texts.top;
  EXPECT_TRUE(has(texts.bottom, "line_k_max: Gate of a line segment")) << texts.bottom;
}

TEST_F(ViewSessionTest, StepsThroughTheInputsAndStopsAtTheEnds) {
  ViewSession shown = session();
  EXPECT_FALSE(shown.press(C::PreviousInput).redraw);
  const ViewChange change = shown.press(C::NextInput);
  EXPECT_TRUE(change.redraw);
  EXPECT_FALSE(change.look) << "the view stays over a sequence";
  EXPECT_EQ(shown.input().name, "room1");
  press(shown, C::NextInput, 5);
  EXPECT_EQ(shown.input().name, "room2");
  EXPECT_TRUE(has(viewTexts(shown).top, "[3/3] room2"));
  shown.press(C::PreviousInput);
  EXPECT_EQ(shown.input().name, "room1");
  shown.press(C::FirstInput);
  EXPECT_EQ(shown.input().name, "room0");
  shown.press(C::LastInput);
  EXPECT_EQ(shown.input().name, "room2");
}

TEST_F(ViewSessionTest, FramesOfOneSourceDiffer) {
  ViewSession shown = session();
  const Eigen::Vector3f before = shown.scene().points[100].position;
  shown.press(C::NextInput);
  EXPECT_NE(shown.scene().points[100].position, before);
}

TEST_F(ViewSessionTest, SensorsGoFromTheFramesOwnToAutoAndThePresets) {
  ViewSession shown = session();
  shown.press(C::NextSensor);
  EXPECT_EQ(shown.sensorName().rfind("auto (axial", 0), 0U) << shown.sensorName();
  shown.press(C::NextSensor);
  EXPECT_EQ(shown.sensorName(), SensorModel::presetNames().front());
  press(shown, C::PreviousSensor, 3);
  EXPECT_EQ(shown.sensorName(), SensorModel::presetNames().back());
  press(shown, C::NextSensor, 1);
  EXPECT_EQ(shown.sensorName(), "0.0005,0.0005,1");
}

TEST_F(ViewSessionTest, ANoiseThatWasGivenIsTheFirstChoiceAndStaysFromFrameToFrame) {
  SegmentOptions options;
  options.noise = "realsense";
  ViewSession shown = session(options);
  EXPECT_EQ(shown.sensorName(), "realsense");
  shown.press(C::NextSensor);
  shown.press(C::NextInput);
  EXPECT_EQ(shown.sensorName().rfind("auto", 0), 0U) << shown.sensorName();
}

TEST_F(ViewSessionTest, ParametersAreChangedAndSeenAtOnce) {
  ViewSession shown = session();
  press(shown, C::RaiseParameter, 2);
  EXPECT_NEAR(shown.parameters().inverse_depth.line_k_max, 1.7, 1e-9);
  EXPECT_TRUE(has(viewTexts(shown).top, "> line_k_max        1.7"));
  while (std::string(shown.fields()[shown.field()]->name) != "inverse_depth.min_points")
    shown.press(C::PreviousParameter);
  press(shown, C::RaiseParameter, 70);  // more than the room has pixels
  EXPECT_GT(shown.parameters().inverse_depth.min_points, 4800);
  EXPECT_EQ(shown.result().planes.size(), 0U);
  for (const ViewPoint& point : shown.scene().points) EXPECT_EQ(point.label, 0);
  press(shown, C::LowerParameter, 70);
  EXPECT_EQ(shown.parameters().inverse_depth.min_points, 60);
  EXPECT_EQ(shown.result().planes.size(), 3U);
  shown.press(C::ResetParameters);
  EXPECT_EQ(shown.parameters().inverse_depth.min_points, 60);
  EXPECT_EQ(shown.parameters().inverse_depth.line_k_max, 1.5);
}

TEST_F(ViewSessionTest, ParametersGoRound) {
  ViewSession shown = session();
  const std::size_t start = shown.field();
  press(shown, C::NextParameter, static_cast<int>(shown.fields().size()));
  EXPECT_EQ(shown.field(), start);
}

TEST_F(ViewSessionTest, TheModeIsSwitchedWithItsParameters) {
  ViewSession shown = session();
  shown.press(C::SwitchMode);
  EXPECT_EQ(shown.parameters().mode, Mode::Paper);
  EXPECT_STREQ(shown.fields()[shown.field()]->name, "paper.line_k_max");
  EXPECT_TRUE(has(viewTexts(shown).top, "mode paper"));
  EXPECT_TRUE(has(viewTexts(shown).top, "max_gap"));
  EXPECT_EQ(shown.problem(), "");
  EXPECT_GE(shown.result().planes.size(), 3U);
  shown.press(C::SwitchMode);
  EXPECT_EQ(shown.parameters().mode, Mode::InverseDepth);
}

TEST_F(ViewSessionTest, PlanesAreSelectedInTurnAndTheirNumbersRead) {
  ViewSession shown = session();
  shown.press(C::NextPlane);
  EXPECT_EQ(shown.style().selected, 1);
  shown.press(C::NextPlane);
  const Plane& plane = shown.result().planes[1];
  const std::string numbers = viewTexts(shown).bottom;
  char line[80];
  std::snprintf(line, sizeof line, "d = %9.5f +- %.5f m", plane.coefficients(3),
                std::sqrt(plane.coefficients_covariance(3, 3)));
  EXPECT_TRUE(has(numbers, "plane 2 of 3, ")) << numbers;
  EXPECT_TRUE(has(numbers, line)) << numbers << line;
  EXPECT_TRUE(has(numbers, std::to_string(plane.pixel_count) + " pixels, ")) << numbers;
  EXPECT_TRUE(has(numbers, "rms ") && has(numbers, "confidence ") && has(numbers, " m2")) << numbers;
  press(shown, C::NextPlane, 2);
  EXPECT_EQ(shown.style().selected, 0) << "none comes after the last";
  shown.press(C::PreviousPlane);
  EXPECT_EQ(shown.style().selected, 3);
  shown.press(C::SelectNone);
  EXPECT_EQ(shown.style().selected, 0);
  shown.select(2);
  shown.press(C::RaiseParameter);
  EXPECT_EQ(shown.style().selected, 0) << "numbers of planes change with the segmentation";
}

TEST_F(ViewSessionTest, WhatIsShownIsSwitched) {
  ViewSession shown = session();
  shown.press(C::SwitchOutlines);
  EXPECT_TRUE(shown.scene().outlines.empty());
  shown.press(C::SwitchNormals);
  EXPECT_TRUE(shown.scene().arrows.empty());
  shown.press(C::SwitchUnlabelled);
  for (const ViewPoint& point : shown.scene().points) EXPECT_GT(point.label, 0);
  const double size = shown.pointSize();
  shown.press(C::LargerPoints);
  EXPECT_GT(shown.pointSize(), size);
  press(shown, C::SmallerPoints, 50);
  EXPECT_EQ(shown.pointSize(), 1.0);
  shown.press(C::SwitchHelp);
  EXPECT_EQ(viewTexts(shown).top, keyHelp());
  shown.press(C::SwitchHelp);
  shown.press(C::SwitchTexts);
  EXPECT_EQ(viewTexts(shown).top + viewTexts(shown).bottom, "");
}

TEST_F(ViewSessionTest, PointsMeshAndBothFollowEachOther) {
  EPCC_NEED_SURFACES();
  ViewSession shown = session();
  const auto drawn = [&] { return std::pair(shown.scene().draws_points, !shown.scene().triangles.empty()); };
  EXPECT_EQ(drawn(), std::pair(true, false));
  shown.press(C::NextSurface);
  EXPECT_EQ(drawn(), std::pair(false, true));
  EXPECT_EQ(shown.scene().points.size(), 80U * 60U) << "to select a plane by, and to count";
  shown.press(C::NextSurface);
  EXPECT_EQ(drawn(), std::pair(true, true));
  shown.press(C::NextSurface);
  EXPECT_EQ(drawn(), std::pair(true, false));
  ViewStyle style;
  style.points = false;
  ViewSession outlines({}, test::roomInputs(), style);
  EXPECT_FALSE(outlines.scene().draws_points);
  outlines.press(C::NextSurface);
  EXPECT_TRUE(outlines.scene().draws_points);
}

TEST_F(ViewSessionTest, SurfacesAreThoseOfTheResultAndFoundWhereTheyAreDrawn) {
  EPCC_NEED_SURFACES();
  ViewStyle style;
  style.outline_kind = OutlineKind::Contours;
  ViewSession shown({}, test::roomInputs(), style);
  EXPECT_TRUE(shown.surfaces().polygons.surfaces.empty());
  const std::size_t contour_points = shown.scene().outlines.at(0).points.size();
  shown.press(C::SwitchOutlineKind);
  EXPECT_EQ(shown.surfaces().polygons.surfaces.size(), 3U);
  EXPECT_LT(shown.scene().outlines.at(0).points.size(), contour_points / 2) << "a line where the pixels have steps";
  const double area = shown.surfaces().polygons.surfaces[0].area;
  shown.press(C::NextInput);
  EXPECT_EQ(shown.surfaces().polygons.surfaces.size(), 3U);
  EXPECT_NE(shown.surfaces().polygons.surfaces[0].area, area);
  shown.press(C::NextSurface);
  while (std::string(shown.fields()[shown.field()]->name) != "inverse_depth.min_points")
    shown.press(C::PreviousParameter);
  press(shown, C::RaiseParameter, 70);  // more than the room has pixels
  EXPECT_TRUE(shown.surfaces().polygons.surfaces.empty());
  EXPECT_TRUE(shown.scene().triangles.empty());
  EXPECT_EQ(shown.notice(), "");
  shown.press(C::SwitchOutlineKind);
  shown.press(C::SwitchOutlines);
  shown.press(C::SwitchOutlineKind);
  EXPECT_TRUE(shown.style().outlines) << "who asks for polygons wants to see them";
}

TEST_F(ViewSessionTest, ASelectedPlanesPolygonIsDescribed) {
  EPCC_NEED_SURFACES();
  ViewSession shown = session();
  shown.press(C::NextPlane);
  char line[80];
  std::snprintf(line, sizeof line, "polygon of %.3f m2, 1 piece, 0 holes", shown.surfaces().polygons.surfaces[0].area);
  EXPECT_TRUE(has(viewTexts(shown).bottom, line)) << viewTexts(shown).bottom << '\n' << line;
}

TEST_F(ViewSessionTest, ABuildWithoutSurfacesSaysSoInTheWindow) {
  EPCC_NEED_NO_SURFACES();
  ViewSession shown = session();
  EXPECT_EQ(shown.notice(), "");
  EXPECT_FALSE(shown.scene().outlines.empty()) << "contours";
  for (const C key : {C::NextSurface, C::SwitchOutlineKind}) {
    EXPECT_TRUE(shown.press(key).redraw);
    EXPECT_EQ(shown.notice(), "no polygons, no mesh: " + surfacesMissing());
    EXPECT_TRUE(has(viewTexts(shown).top, shown.notice()));
    EXPECT_TRUE(shown.scene().draws_points);
    EXPECT_FALSE(shown.scene().outlines.empty());
    EXPECT_TRUE(shown.press(C::NextParameter).redraw);
    EXPECT_EQ(shown.notice(), "");
  }
}

TEST_F(ViewSessionTest, PlacesGoRoundAndQuitQuits) {
  ViewSession shown = session();
  EXPECT_TRUE(shown.press(C::NextPlace).look);
  EXPECT_EQ(shown.place(), ViewPlace::Slanted);
  press(shown, C::NextPlace, 2);
  EXPECT_EQ(shown.place(), ViewPlace::Sensor);
  EXPECT_TRUE(shown.press(C::SamePlace).look);
  EXPECT_TRUE(shown.press(C::Quit).quit);
}

TEST_F(ViewSessionTest, AnInputThatCannotBeUsedSaysWhyAndCanBeLeft) {
  std::vector<SegmentInput> inputs = test::roomInputs();
  inputs[1].problem = InputError("room1", "file", "does not exist");
  ViewSession shown({}, inputs);
  shown.press(C::NextInput);
  EXPECT_EQ(shown.problem(), "room1: file: does not exist");
  EXPECT_TRUE(has(viewTexts(shown).top, "cannot be used: room1: file: does not exist"));
  EXPECT_TRUE(shown.scene().points.empty());
  for (const ViewKey& key : viewKeys())  // nothing to show is no reason to end
    if (key.command != C::NextInput && key.command != C::PreviousInput && key.command != C::FirstInput &&
        key.command != C::LastInput)
      shown.press(key.command);
  EXPECT_EQ(shown.problem(), "room1: file: does not exist");
  EXPECT_TRUE(shown.press(C::NextInput).look);
  EXPECT_EQ(shown.problem(), "");
  EXPECT_GE(shown.scene().points.size(), 1000U);
}

TEST_F(ViewSessionTest, DoubtsAreShownWithThePlanes) {
  std::vector<LabelledFrame> frames{test::tinyFrame("room", 1), test::tinyFrame("noise", 1)};
  std::mt19937 generator(1);
  std::uniform_real_distribution<float> anywhere(0.5F, 60.0F);
  for (float& z : frames[1].depth.data) z = anywhere(generator);
  std::vector<SegmentInput> inputs = test::inputsOf(std::move(frames));
  SegmentOptions options;
  options.noise = "auto";
  ViewSession shown(options, inputs);
  EXPECT_EQ(shown.doubt(), "");
  EXPECT_FALSE(has(viewTexts(shown).top, "doubtful"));
  shown.press(C::NextInput);
  EXPECT_NE(shown.doubt(), "");
  EXPECT_TRUE(has(viewTexts(shown).top, "doubtful: ")) << viewTexts(shown).top;
}

// What the reader of the file knows is told as epcc_segment tells it, with each sensor.
TEST_F(ViewSessionTest, BytesInTheWrongOrderAreNamedWhateverTheSensor) {
  std::vector<LabelledFrame> frames{test::tinyFrame("room", 1)};
  frames[0].bytes_are_swapped = true;
  for (const char* noise : {"auto", "0.003,0,1"}) {
    SegmentOptions options;
    options.noise = noise;
    EXPECT_TRUE(has(ViewSession(options, test::inputsOf(frames)).doubt(), "wrong order")) << noise;
  }
}

TEST_F(ViewSessionTest, WhatTheMethodRefusesIsTold) {
  SegmentOptions options;
  options.parameters.inverse_depth.line_k_max = -1.0;
  const ViewSession shown = session(options);
  EXPECT_TRUE(has(shown.problem(), "line_k_max")) << shown.problem();
}

}  // namespace
}  // namespace epcc
