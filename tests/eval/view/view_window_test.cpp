// SPDX-License-Identifier: BSD-3-Clause
// The window of epcc_view on a virtual display, used as a person would: keys, a click, and both ways to close it.
#include <gtest/gtest.h>

#include "datasets/files/labelled_frame.h"
#include "eval/pictures/label_colors.h"
#include "tests/eval/view/virtual_display.h"
#include "tests/support/rendered_room.h"
#include "tests/support/run_tool.h"
#include "tests/support/temp_folder.h"
// Its macros come last.
#include "tests/eval/view/window_hand.h"

namespace epcc::test {
namespace {

/// Pixels of a colour, and the one in the middle of their list.
struct Seen {
  std::size_t pixels = 0;
  int x = 0, y = 0;
};

Seen seenOf(const ColorImage& image, const Rgb& color) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < image.data.size(); ++i)
    if (image.data[i].r == color.r && image.data[i].g == color.g && image.data[i].b == color.b) places.push_back(i);
  if (places.empty()) return {};
  const auto middle = static_cast<int>(places[places.size() / 2]);
  return {places.size(), middle % image.width, middle / image.width};
}

class ViewWindowTest : public TempFolderTest {
 protected:
  void SetUp() override {
    TempFolderTest::SetUp();
    if (!display_.exists()) GTEST_SKIP() << "Xvfb not found (Debian package xvfb)";
    for (const unsigned seed : {1U, 2U}) {
      RenderedRoom room = renderRoom(cornerPlanes(), testCamera(320, 240));
      addNoise(room, SensorModel::axial(0.0005, 0.0005), seed);
      LabelledFrame frame;
      frame.name = "room" + std::to_string(seed);
      frame.camera.camera = room.camera;
      frame.camera.depth_scale = 0.0001;
      frame.camera.noise = "0.0005,0.0005,1";
      frame.depth = DepthImage(320, 240);
      if (seed == 1) frame.depth.data = room.depth;  // the second measures nothing
      writeLabelledFrame(folder(), frame);
    }
    start();
  }
  void TearDown() override {
    if (process_ > 0 && !ended_) ::kill(process_, SIGKILL);
    if (process_ > 0 && !ended_) ::waitpid(process_, nullptr, 0);
  }

  void start() {
    const std::string program = programFile("epcc_view");
    process_ = ::fork();
    if (process_ == 0) {
      becomeHelper();
      ::setenv("DISPLAY", display_.name().c_str(), 1);
      ::execl(program.c_str(), program.c_str(), folder().c_str(), "--size", "640x400", "--keys", "t,o,a", nullptr);
      ::_exit(127);
    }
    hand_ = std::make_unique<WindowHand>(display_.name());
    ASSERT_TRUE(hand_->find("epcc_view"));
    ASSERT_TRUE(shows(1) && shows(2)) << "the planes are drawn";
  }
  std::size_t pixels(std::int32_t label) { return seenOf(hand_->picture(), labelColor(label)).pixels; }
  /// One plane in its colour, another dimmed, in one picture: between two there may be none.
  bool shows(std::int32_t label, std::int32_t dimmed) {
    return waitFor([&] {
      const ColorImage picture = hand_->picture();
      return seenOf(picture, labelColor(label)).pixels > 1000 && seenOf(picture, labelColor(dimmed)).pixels == 0;
    });
  }
  bool shows(std::int32_t label) {
    return waitFor([&] { return pixels(label) > 1000; });
  }
  bool hides(std::int32_t label) {
    return waitFor([&] { return pixels(label) == 0; });
  }
  /// The exit code; -1 if it does not end or is ended by a signal.
  int ending() {
    int status = 0;
    ended_ = waitFor([&] { return ::waitpid(process_, &status, WNOHANG) == process_; });
    return ended_ && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  VirtualDisplay display_;
  std::unique_ptr<WindowHand> hand_;
  pid_t process_ = -1;
  bool ended_ = false;
};

TEST_F(ViewWindowTest, KeysSelectPlanesAndStepThroughTheInputs) {
  hand_->key("Tab");
  EXPECT_TRUE(shows(1, 2));
  hand_->key("Escape");
  EXPECT_TRUE(shows(2));
  hand_->key("n");
  EXPECT_TRUE(hides(1)) << "nothing is measured there";
  hand_->key("Left");
  EXPECT_TRUE(shows(1));
  hand_->key("q");
  EXPECT_EQ(ending(), 0);
}

TEST_F(ViewWindowTest, AClickSelectsThePlaneUnderIt) {
  for (const std::int32_t label : {2, 3, 1}) {
    const Seen place = seenOf(hand_->picture(), labelColor(label));
    hand_->click(place.x, place.y);
    EXPECT_TRUE(shows(label, label % 3 + 1)) << label;
    hand_->key("Escape");
    EXPECT_TRUE(shows(1) && shows(2) && shows(3));
    hand_->key("f");  // so do the mesh, and both together
  }
  hand_->key("q");
  EXPECT_EQ(ending(), 0);
}

TEST_F(ViewWindowTest, ClosingTheWindowEndsTheProgram) {
  hand_->close();
  EXPECT_EQ(ending(), 0);
}

}  // namespace
}  // namespace epcc::test
