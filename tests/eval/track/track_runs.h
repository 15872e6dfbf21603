// SPDX-License-Identifier: BSD-3-Clause
// Runs of epcc_track on a rendered sequence.
#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "datasets/files/trajectory_file.h"
#include "datasets/rendered/scene_sequence.h"
#include "eval/track/track_command.h"
#include "tests/support/run_tool.h"

namespace epcc::test {

constexpr std::size_t kTrackedFrames = 24;

/// A desk with a box, rendered once for all tests of a suite.
class TrackRuns : public TempFolderTest {
 protected:
  static void SetUpTestSuite() {
    frames_ = new TempFolder;
    SequenceRecipe recipe;
    recipe.scene = "a";
    recipe.path = "orbit";
    recipe.frames = kTrackedFrames;
    recipe.options.camera = sceneCamera(240, 135);
    recipe.noise = parseNoise("white:0.001,0.001,0").value();
    const SceneSequence sequence(recipe);
    for (std::size_t i = 0; i < kTrackedFrames; ++i) writeLabelledFrame(frames_->path(), sequence.frame(i));
    writeTrajectory(frames_->path("groundtruth.txt"), sequence.trajectory());
  }
  static void TearDownTestSuite() { delete frames_; }
  static std::string frames() { return frames_->path(); }

  ToolResult run(const std::vector<std::string>& arguments) { return callTool(trackMain, "epcc_track", arguments); }
  std::string outputOf(const std::vector<std::string>& arguments) {
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result.out;
  }
  void expectFailure(const std::vector<std::string>& arguments, int code, const std::string& words) {
    epcc::test::expectFailure(run(arguments), "epcc_track", code, words);
  }
  nlohmann::json tracks(const std::string& folder) { return nlohmann::json::parse(read(folder + "/tracks.json")); }

 private:
  inline static TempFolder* frames_ = nullptr;
};

/// Of a frame of it.
inline std::string frameName(std::size_t i) {
  char text[40];
  std::snprintf(text, sizeof text, "a_000_orbit_%06zu", i);
  return text;
}

}  // namespace epcc::test
