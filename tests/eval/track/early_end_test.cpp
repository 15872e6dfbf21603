// SPDX-License-Identifier: BSD-3-Clause
// Runs that end before their last frame: what is known of the frames that wait for labels is written.
#include <gtest/gtest.h>

#include <filesystem>

#include "datasets/files/png_io.h"
#include "datasets/rendered/scene_sequence.h"
#include "eval/track/track_command.h"
#include "eval/track/waiting_labels.h"
#include "tests/support/address_limit.h"
#include "tests/support/run_tool.h"

namespace epcc::test {
namespace {

namespace fs = std::filesystem;

class EarlyEnd : public TempFolderTest {
 protected:
  /// Two planes side by side, of tracks that no tracker knows.
  static TrackedFrame twoPlanes() {
    TrackedFrame tracked;
    tracked.segmentation.labels = {0, 1, 2, 2};
    tracked.track_of_plane = {0, 1};
    tracked.label_of_plane = {7, 0};
    return tracked;
  }
};

TEST_F(EarlyEnd, LabelsThatWereKnownDoNotNeedTheMap) {
  const PlaneTracker without_map;
  WaitingLabels waiting;
  waiting.add(path("a.png"), 2, twoPlanes(), without_map);
  EXPECT_FALSE(exists("a.png")) << "it waits";
  waiting.rescue();
  EXPECT_EQ(readGray16(path("a.png")).data, (std::vector<std::uint16_t>{0, 7, 0, 0}));
}

TEST_F(EarlyEnd, WhatCannotBeWrittenIsLeftOut) {
  const PlaneTracker without_map;
  WaitingLabels waiting;
  waiting.add(path("no folder/a.png"), 2, twoPlanes(), without_map);
  waiting.add(path("b.png"), 2, twoPlanes(), without_map);
  waiting.rescue();
  EXPECT_EQ(names("."), std::vector<std::string>{"b.png"});
}

TEST_F(EarlyEnd, FramesThatWaitAreWrittenWhereMemoryRunsOut) {
  EPCC_NEED_ADDRESS_LIMIT();
  SequenceRecipe recipe;
  recipe.scene = "a";
  recipe.path = "sway";
  recipe.frames = 2;
  recipe.options.camera = sceneCamera(240, 135);
  const SceneSequence sequence(recipe);
  fs::create_directories(path("frames"));
  for (std::size_t i = 0; i < recipe.frames; ++i) {
    LabelledFrame frame = sequence.frame(i);
    frame.name = std::to_string(i);
    writeLabelledFrame(path("frames"), frame);
  }
  LabelledFrame large = sequence.frame(0);
  large.name = "2";
  large.camera.camera.width = large.camera.camera.height = 5000;
  large.depth = DepthImage(5000, 5000);
  large.labels = LabelImage();
  large.camera.extra.clear();
  writeLabelledFrame(path("frames"), large);

  const AddressLimit limit(64U << 20);
  ASSERT_TRUE(limit.ok());
  const ToolResult result = callTool(trackMain, "epcc_track", {path("frames"), "--out", path("o")});
  expectFailure(result, "epcc_track", 3, "memory");
  EXPECT_EQ(names("o"), (std::vector<std::string>{".epcc-lock", "0_labels.png", "1_labels.png"}))
      << "planes have labels from the third";
}

}  // namespace
}  // namespace epcc::test
