// SPDX-License-Identifier: BSD-3-Clause
// epcc_scene: frames written and read back, the same bytes for the same seed, and every wrong command line.
#include "eval/scene_command.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "datasets/scene.h"
#include "support/real_frames.h"

namespace epcc {
namespace {

namespace fs = std::filesystem;

class SceneCommand : public ::testing::Test {
 protected:
  SceneCommand() {
    std::string pattern = (fs::temp_directory_path() / "epcc_scene_test_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) std::abort();
    folder_ = pattern;
  }
  ~SceneCommand() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  int run(const std::vector<std::string>& arguments) {
    std::vector<const char*> argv{"epcc_scene"};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    out_.str("");
    err_.str("");
    return sceneMain(static_cast<int>(argv.size()), argv.data(), out_, err_);
  }
  void expectFailure(const std::vector<std::string>& arguments, int code, const std::string& words) {
    EXPECT_EQ(run(arguments), code) << err_.str();
    const std::string text = err_.str();
    EXPECT_EQ(text.rfind("epcc_scene: ", 0), 0U) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_NE(text.find(words), std::string::npos) << text;
    EXPECT_EQ(out_.str(), "");
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string bytes(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  fs::path folder_;
  std::ostringstream out_, err_;
};

TEST_F(SceneCommand, WritesFramesThatReadBack) {
  ASSERT_EQ(run({"a", "--seed", "7", "--out", path("f")}), 0) << err_.str();
  ASSERT_EQ(listLabelledFrames(path("f")), std::vector<std::string>{"a_007"});
  const LabelledFrame read = readLabelledFrame(path("f"), "a_007"), made = renderScene("a", 7);
  EXPECT_EQ(read.labels.data, made.labels.data);
  EXPECT_EQ(*read.camera.noise, "rendered");
  EXPECT_EQ(read.camera.extra["planes"], made.camera.extra["planes"]);
  EXPECT_DOUBLE_EQ(read.camera.camera.fx, made.camera.camera.fx);
  for (std::size_t i = 0; i < read.depth.data.size(); ++i)
    ASSERT_NEAR(read.depth.data[i], made.depth.data[i], 0.00011F);
}

TEST_F(SceneCommand, GivesTheSameBytesForTheSameSeed) {
  for (const char* folder : {"x", "y"})
    ASSERT_EQ(run({"b", "--seed", "3", "--noise", "stereo", "--out", path(folder)}), 0) << err_.str();
  for (const char* file : {"b_003_depth.png", "b_003_labels.png", "b_003.json"}) {
    ASSERT_FALSE(bytes(std::string("x/") + file).empty());
    EXPECT_EQ(bytes(std::string("x/") + file), bytes(std::string("y/") + file)) << file;
  }
}

TEST_F(SceneCommand, TakesRangesOfSeedsAndAllScenes) {
  ASSERT_EQ(run({"all", "--seeds", "2:3", "--out", path("f")}), 0) << err_.str();
  EXPECT_EQ(listLabelledFrames(path("f")).size(), 8U);
  ASSERT_EQ(run({"a", "--seed", "10", "--count", "3", "--out", path("g")}), 0) << err_.str();
  EXPECT_EQ(listLabelledFrames(path("g")), (std::vector<std::string>{"a_010", "a_011", "a_012"}));
}

TEST_F(SceneCommand, TakesALargestSeed) {
  ASSERT_EQ(run({"a", "--seed", "18446744073709551615", "--out", path("f")}), 0) << err_.str();
  EXPECT_EQ(listLabelledFrames(path("f")), std::vector<std::string>{"a_18446744073709551615"});
  expectFailure({"a", "--seed", "18446744073709551615", "--count", "2", "--out", path("f")}, 2, "--count");
}

TEST_F(SceneCommand, TakesAnotherCamera) {
  ASSERT_EQ(
      run({"c", "--width", "320", "--height", "200", "--fx", "170", "--noise", "white:d435i", "--out", path("f")}), 0)
      << err_.str();
  const LabelledFrame frame = readLabelledFrame(path("f"), "c_000");
  EXPECT_EQ(frame.depth.width, 320);
  EXPECT_EQ(frame.depth.height, 200);
  EXPECT_EQ(frame.camera.camera.fy, 170.0);
  EXPECT_EQ(*frame.camera.noise, "d435i");
}

TEST_F(SceneCommand, RefusesWrongCommandLines) {
  const std::string out = path("none");
  expectFailure({}, 2, "SCENE");
  expectFailure({"a"}, 2, "--out");
  expectFailure({"kitchen", "--out", out}, 2, "kitchen");
  expectFailure({"a", "b", "--out", out}, 2, "b");
  expectFailure({"a", "--out", out, "--unknown"}, 2, "--unknown");
  expectFailure({"a", "--out", out, "--seed", "-1"}, 2, "--seed");
  expectFailure({"a", "--out", out, "--seed", "1.5"}, 2, "--seed");
  expectFailure({"a", "--out", out, "--count", "0"}, 2, "--count");
  expectFailure({"a", "--out", out, "--seeds", "5"}, 2, "--seeds");
  expectFailure({"a", "--out", out, "--seeds", "5:4"}, 2, "--seeds");
  expectFailure({"a", "--out", out, "--seeds", "0:99999999"}, 2, "100000");
  expectFailure({"a", "--out", out, "--seeds", "1:2", "--seed", "1"}, 2, "excludes");
  expectFailure({"a", "--out", out, "--noise", "loud"}, 2, "loud");
  expectFailure({"a", "--out", out, "--noise", "white:unknown"}, 2, "unknown");
  expectFailure({"a", "--out", out, "--width", "0"}, 2, "--width");
  expectFailure({"a", "--out", out, "--width", "99999"}, 2, "--width");
  expectFailure({"a", "--out", out, "--fx", "nan"}, 2, "fx");
  expectFailure({"a", "--out", out, "--fx", "-3"}, 2, "fx");
  expectFailure({"a", "--measure-noise", out}, 2, "--measure-noise");
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(SceneCommand, SaysWhatCannotBeReadOrWritten) {
  std::ofstream(path("file")) << "x";
  expectFailure({"a", "--out", path("file")}, 4, "file");
  expectFailure({"--measure-noise", path("missing")}, 3, "missing");
  fs::create_directory(path("empty"));
  expectFailure({"--measure-noise", path("empty")}, 3, "no labelled frame");
}

TEST_F(SceneCommand, HelpsAndNamesItsVersion) {
  EXPECT_EQ(run({"--help"}), 0);
  EXPECT_NE(out_.str().find("--noise"), std::string::npos);
  EXPECT_EQ(run({"--version"}), 0);
  EXPECT_EQ(out_.str().rfind("epcc_scene ", 0), 0U);
}

TEST_F(SceneCommand, MeasuresRealFrames) {
  EPCC_NEED_REAL_FRAMES("realsense");
  ASSERT_EQ(run({"--measure-noise", test::realFolder("realsense")}), 0) << err_.str();
  EXPECT_NE(out_.str().find("stereo-registered: 6 frames"), std::string::npos);
  EXPECT_NE(out_.str().find("| columns, simulated |"), std::string::npos);
}

}  // namespace
}  // namespace epcc
