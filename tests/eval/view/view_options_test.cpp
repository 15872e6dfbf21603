// SPDX-License-Identifier: BSD-3-Clause
// The command line of epcc_view: its own options, and those of epcc_segment.
#include "eval/view/view_options.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/run_tool.h"

namespace epcc {
namespace {

/// What was read, and how it ended: -1 is "to be carried out".
struct Reading {
  ViewOptions options;
  test::ToolResult result;
};

Reading read(const std::vector<std::string>& arguments) {
  Reading reading;
  std::vector<const char*> argv{"epcc_view"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  std::ostringstream out, err;
  const auto code = parseViewOptions(static_cast<int>(argv.size()), argv.data(), reading.options, out, err);
  reading.result = {code.value_or(-1), out.str(), err.str()};
  return reading;
}

void expectUsage(const std::vector<std::string>& arguments, const std::string& words) {
  test::expectFailure(read(arguments).result, "epcc_view", 2, words);
}

TEST(ViewOptions, TheWindowsOptions) {
  const Reading plain = read({"a.pcd"});
  EXPECT_EQ(plain.result.exit_code, -1) << plain.result.err;
  EXPECT_EQ(plain.options.snapshot, "");
  EXPECT_EQ(plain.options.width, 1280);
  EXPECT_EQ(plain.options.height, 800);
  const Reading all = read({"a.pcd", "b", "--snapshot", "c.png", "--size", "640x480", "--keys", "n,Tab"});
  EXPECT_EQ(all.result.exit_code, -1) << all.result.err;
  EXPECT_EQ(all.options.snapshot, "c.png");
  EXPECT_EQ(all.options.width, 640);
  EXPECT_EQ(all.options.height, 480);
  EXPECT_EQ(all.options.keys, (std::vector<std::string>{"n", "Tab"}));
  EXPECT_EQ(all.options.input.inputs, (std::vector<std::string>{"a.pcd", "b"}));
}

TEST(ViewOptions, InputSensorAndMethodAsInEpccSegment) {
  const Reading reading = read({"a.png",
                                "--fx",
                                "100",
                                "--fy",
                                "101",
                                "--cx",
                                "50",
                                "--cy",
                                "51",
                                "--depth-scale",
                                "0.002",
                                "--noise",
                                "realsense",
                                "--mode",
                                "paper",
                                "--line-k-max",
                                "2.5",
                                "--set",
                                "paper.max_gap=0.2",
                                "--min-depth",
                                "0.5",
                                "--max-depth",
                                "5"});
  EXPECT_EQ(reading.result.exit_code, -1) << reading.result.err;
  const SegmentOptions& input = reading.options.input;
  ASSERT_TRUE(input.camera);
  EXPECT_EQ(input.camera->fy, 101.0);
  EXPECT_EQ(input.camera->depth_scale, 0.002);
  EXPECT_EQ(input.noise, "realsense");
  EXPECT_EQ(input.parameters.mode, Mode::Paper);
  EXPECT_EQ(input.parameters.paper.line_k_max, 2.5);
  EXPECT_EQ(input.parameters.paper.max_gap, 0.2);
  EXPECT_EQ(input.reading.min_depth, 0.5);
  EXPECT_EQ(input.reading.max_depth, 5.0);
}

TEST(ViewOptions, WhatIsDrawnAtTheStart) {
  const ViewStyle plain = read({"a.pcd"}).options.style;
  EXPECT_TRUE(plain.points && plain.outlines && plain.normals && !plain.mesh);
  const ViewStyle contours = read({"a.pcd", "--draw", "contours"}).options.style;
  EXPECT_TRUE(contours.outlines && contours.outline_kind == OutlineKind::Contours);
  EXPECT_FALSE(contours.points || contours.mesh || contours.normals);
  const ViewStyle bare = read({"a.pcd", "--draw", "points,normals"}).options.style;
  EXPECT_TRUE(bare.points && bare.normals && !bare.outlines && !bare.mesh);
  expectUsage({"a.pcd", "--draw", "points,lines"}, "--draw: 'lines' is none of points, mesh, polygons");
  for (const char* empty : {",", "points,"}) expectUsage({"a.pcd", std::string("--draw=") + empty}, "'' is none of");
  expectUsage({"a.pcd", "--draw", "polygons,contours"}, "--draw: outlines are polygons or contours");
}

TEST(ViewOptions, MeshAndPolygonsNeedTheirLibrary) {
  for (const char* word : {"mesh", "polygons"}) {
    if (!surfacesMissing().empty()) {
      expectUsage({"a.pcd", "--draw", word}, "--draw: this program was built without GEOS");
      continue;
    }
    const ViewStyle style = read({"a.pcd", "--draw", word}).options.style;
    EXPECT_EQ(style.mesh, std::string(word) == "mesh");
    EXPECT_EQ(style.outlines, std::string(word) == "polygons");
    EXPECT_TRUE(style.needsSurfaces());
    EXPECT_FALSE(style.points || style.normals);
  }
}

TEST(ViewOptions, HelpAndVersion) {
  const Reading help = read({"--help"});
  EXPECT_EQ(help.result.exit_code, 0);
  for (const char* word : {"--snapshot", "--draw", "--keys", "--size", "--camera", "--noise", "--mode", "--set",
                           "--projection", "xvfb-run", "Exit codes"})
    EXPECT_NE(help.result.out.find(word), std::string::npos) << word;
  EXPECT_EQ(help.result.out.find("--labels"), std::string::npos);
  EXPECT_EQ(read({"--version"}).result.out.rfind("epcc_view ", 0), 0U);
}

TEST(ViewOptions, WhatIsWrongIsNamed) {
  expectUsage({}, "INPUT");
  expectUsage({"a.pcd", "--labels", "b.png"}, "--labels");
  expectUsage({"a.pcd", "--keys", "n,zz"}, "--keys: 'zz' is no key of the window");
  expectUsage({"a.pcd", "--keys", ","}, "--keys: '' is no key of the window");
  expectUsage({"a.pcd", "--snapshot", ""}, "the name is empty");
  expectUsage({"a.pcd", "--noise", "nonsense"}, "nonsense");
  expectUsage({"a.pcd", "--set", "inverse_depth.line_k_max=-1"}, "line_k_max");
  for (const char* size : {"640", "640x", "640x480x3", "0x480", "159x480", "9000x480", "-640x480", "ax480"})
    expectUsage({"a.pcd", std::string("--size=") + size}, "is not WIDTHxHEIGHT");
}

}  // namespace
}  // namespace epcc
