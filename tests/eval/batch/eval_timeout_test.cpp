// SPDX-License-Identifier: BSD-3-Clause
// epcc_eval with a time limit for each frame, and without times in its files.
#include <filesystem>

#include "tests/eval/batch/eval_runner.h"

namespace {

namespace fs = std::filesystem;

class EvalTimeout : public epcc::test::EvalToolTest {
 protected:
  void SetUp() override {
    EvalToolTest::SetUp();
    for (unsigned i = 0; i < 4; ++i) writeFrame("rooms", "f" + std::to_string(i), i);
    write("rooms/f2_depth.png", "broken");
  }
  /// Contents of all files by name, of `run.json` aside, which says how the run was made.
  std::map<std::string, std::string> files(const std::string& out) const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(path(out)))
      if (entry.is_regular_file() && entry.path().filename() != "run.json")
        all[fs::relative(entry.path(), path(out)).string()] = epcc::test::bytesOf(entry.path().string());
    return all;
  }
  const std::vector<std::string> arguments_ = {"rooms", "--methods", "epcc,omps", "--overlays", "--no-times"};
  std::vector<std::string> with(const std::vector<std::string>& more) const {
    std::vector<std::string> all = arguments_;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

TEST_F(EvalTimeout, WithoutTimesTwoRunsAreTheSameToTheByte) {
  ASSERT_EQ(run(with({"--out", "one"})).exit_code, 0);
  ASSERT_EQ(run(with({"--out", "two", "--jobs", "2"})).exit_code, 0);
  EXPECT_EQ(files("one"), files("two"));
  EXPECT_TRUE(row("one", "rooms", "epcc").at("median_ms").is_null());
  EXPECT_EQ(read("one/results/rooms/000000/000.json").find("microseconds"), std::string::npos);
}

TEST_F(EvalTimeout, ALimitThatIsNotReachedChangesNothing) {
  const auto plain = run(with({"--out", "plain"}));
  const auto limited = run(with({"--out", "limited", "--frame-timeout", "600", "--jobs", "2"}));
  EXPECT_EQ(limited.exit_code, 0) << limited.err;
  EXPECT_EQ(limited.out, plain.out);
  EXPECT_EQ(limited.err, plain.err);
  EXPECT_EQ(files("limited"), files("plain"));
  const auto in_memory = run(with({"--frame-timeout", "600"}));
  EXPECT_EQ(in_memory.exit_code, 2) << "--overlays needs --out";
  EXPECT_EQ(run({"rooms", "--methods", "epcc,omps", "--no-times", "--frame-timeout", "600"}).out, plain.out);
}

TEST_F(EvalTimeout, AFrameThatTakesTooLongIsAnErrorAndLeavesNoFiles) {
  // A thousand and one runs of RANSAC take longer than a millisecond, whatever the machine.
  const auto result =
      run({"rooms", "--methods", "ransac", "--seeds", "1000", "--frame-timeout", "0.001", "--out", "o"});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  const std::string late = ": takes longer than 0.001 s (--frame-timeout)\n";
  for (const std::string frame : {"f0", "f1", "f3"})
    EXPECT_NE(result.err.find("epcc_eval: rooms/" + frame + ": ransac" + late), std::string::npos) << result.err;
  EXPECT_EQ(row("o", "rooms", "ransac").at("errors"), 4);
  EXPECT_TRUE(exists("o/report.html"));
  for (const auto& [name, bytes] : files("o")) {
    EXPECT_EQ(name.find("_labels.png"), std::string::npos) << name;
    EXPECT_EQ(name.find(".tmp"), std::string::npos) << name;
  }
}

TEST_F(EvalTimeout, WhatAnInterruptedAttemptLeftOfAFailedFrameIsRemoved) {
  write("o/labels/epcc/f2_labels.png", "old");
  write("o/overlays/f2.png", "old");
  ASSERT_EQ(run(with({"--out", "o"})).exit_code, 0);
  EXPECT_FALSE(exists("o/labels/epcc/f2_labels.png"));
  EXPECT_FALSE(exists("o/overlays/f2.png"));
}

TEST_F(EvalTimeout, BothArePartOfTheRun) {
  ASSERT_EQ(run(with({"--out", "o"})).exit_code, 0);
  expectFailure({"rooms", "--methods", "epcc,omps", "--overlays", "--out", "o", "--resume"}, 2,
                "--no-times was on, is off");
  expectFailure(with({"--out", "o", "--resume", "--frame-timeout", "30"}), 2, "--frame-timeout was none, is 30 s");
}

TEST_F(EvalTimeout, LimitsThatMakeNoSenseAreRefused) {
  for (const char* limit : {"0", "-1", "nan", "x", "1e7"})
    expectFailure(with({"--frame-timeout", limit}), 2, "--frame-timeout: ");
  for (const char* option : {"--no-times", "--frame-timeout=5"})
    expectFailure({"rooms", "--methods", "omps", "--repeatability", "1", option}, 2,
                  "does not go with --repeatability");
}

TEST_F(EvalTimeout, AFullDiskEndsItWithoutLeftovers) {
  const auto result =
      runShell("ulimit -f 1; trap '' XFSZ; ", with({"--out", "o", "--frame-timeout", "600", "--jobs", "2"}));
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.err.find("File too large"), std::string::npos) << result.err;
  for (const auto& [name, bytes] : files("o")) EXPECT_EQ(name.find(".tmp"), std::string::npos) << name;
}

}  // namespace
