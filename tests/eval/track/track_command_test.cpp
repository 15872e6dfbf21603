// SPDX-License-Identifier: BSD-3-Clause
// epcc_track on rendered sequences: its files, its poses, its messages, and every wrong command line.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "datasets/files/png_io.h"
#include "eval/program/folder_lock.h"
#include "tests/eval/track/track_runs.h"
#include "tests/support/real_frames.h"
#include "tests/support/swapped_bytes.h"

namespace epcc::test {
namespace {

namespace fs = std::filesystem;

class TrackCommand : public TrackRuns {};

TEST_F(TrackCommand, LeavesAllItsFiles) {
  const std::string out = outputOf({frames(), "--out", path("o"), "--overlays"});
  EXPECT_NE(out.find("24 frames"), std::string::npos) << out;
  EXPECT_NE(out.find("poses known"), std::string::npos) << out;
  std::vector<std::string> expected = {".epcc-lock", "map.png", "times.csv", "tracks.json", "trajectory.txt"};
#ifdef EPCC_WITH_GEOS
  expected.push_back("map.ply");
#endif
  for (std::size_t i = 0; i < kTrackedFrames; ++i)
    for (const char* ending : {"_labels.png", "_overlay.png"}) expected.push_back(frameName(i) + ending);
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(names("o"), expected);
  const Trajectory trajectory = readTrajectory(path("o/trajectory.txt"));
  EXPECT_EQ(trajectory.size(), kTrackedFrames);
  const std::string times = read("o/times.csv");
  EXPECT_EQ(std::count(times.begin(), times.end(), '\n'), static_cast<long>(kTrackedFrames) + 1);
}

TEST_F(TrackCommand, AJumpOfTheTrajectoryIsTold) {
  Trajectory jumps = readTrajectory(frames() + "/groundtruth.txt");
  for (std::size_t i = 12; i < jumps.size(); ++i) jumps[i].pose.translation() += Eigen::Vector3d(0.3, 0.2, 0.35);
  writeTrajectory(path("jumps.txt"), jumps);
  const std::string out = outputOf({frames(), "--poses", path("jumps.txt"), "--out", path("o")});
  EXPECT_NE(out.find("the given poses jumped at frame " + frameName(12)), std::string::npos) << out;
  EXPECT_EQ(outputOf({frames(), "--out", path("p")}).find("jumped"), std::string::npos);
}

TEST_F(TrackCommand, ItsOwnTrajectoryIsNotOverwritten) {
  outputOf({frames(), "--frames", "5", "--out", path("o")});
  const std::string before = read("o/trajectory.txt");
  expectFailure({frames(), "--poses", path("o/trajectory.txt"), "--out", path("o")}, 2, "would overwrite");
  EXPECT_EQ(read("o/trajectory.txt"), before);
}

TEST_F(TrackCommand, NeitherTheSensorModelNorTheTruthOfOtherFramesIsOverwritten) {
  const std::string model = write("o/tracks.json", R"({"noise": "0.01,0,1"})");
  expectFailure({frames(), "--noise", model, "--out", path("o")}, 2, "would overwrite the file of --noise");
  EXPECT_EQ(names("o"), std::vector<std::string>{"tracks.json"});
  fs::copy(frames(), path("copy"));
  const std::string labels = write("copy/" + frameName(2) + "_labels.png", "the truth");
  expectFailure({frames(), "--out", path("copy")}, 2, frameName(0) + "_depth.png: labels beside it");
  EXPECT_EQ(read("copy/" + frameName(2) + "_labels.png"), "the truth");
}

TEST_F(TrackCommand, WhatIsNoFileIsNotReplaced) {
  for (const char* name : {"map.png", "tracks.json"}) {
    fs::create_directories(path(std::string(name) + "_out/") + name);
    expectFailure({frames(), "--frames", "3", "--out", path(std::string(name) + "_out")}, 4, "is a folder");
    EXPECT_EQ(names(std::string(name) + "_out"), (std::vector<std::string>{".epcc-lock", name}));
  }
  fs::create_directory(path("o"));
  ASSERT_EQ(mkfifo(path("o/times.csv").c_str(), 0600), 0);
  expectFailure({frames(), "--frames", "3", "--out", path("o")}, 4, "is not a regular file");
  EXPECT_TRUE(fs::is_fifo(path("o/times.csv")));
}

TEST_F(TrackCommand, TwoAtATimeInOneFolderAreRefused) {
  const FolderLock lock(path("o"));
  expectFailure({frames(), "--frames", "3", "--out", path("o")}, 4, "another process is at work in it");
}

TEST_F(TrackCommand, DoubtfulFramesAreToldOnce) {
  fs::copy(frames(), path("swapped"));
  for (std::size_t i = 1; i < 4; ++i) swapBytesOf(path("swapped/" + frameName(i) + "_depth.png"));
  const ToolResult result = run({path("swapped"), "--frames", "4", "--out", path("o")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err.rfind("epcc_track: 3 frames are doubtful; " + frameName(1) + ": depth: the two bytes", 0), 0U)
      << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_EQ(run({frames(), "--frames", "4", "--out", path("p")}).err, "");
}

TEST_F(TrackCommand, LabelImagesOfOtherFramesAreNotJoined) {
  outputOf({frames(), "--frames", "6", "--overlays", "--out", path("o")});
  const std::string before = read("o/" + frameName(5) + "_labels.png"), list = read("o/tracks.json");
  expectFailure({frames(), "--frames", "5", "--out", path("o")}, 2, frameName(5) + "_labels.png");
  EXPECT_EQ(read("o/" + frameName(5) + "_labels.png"), before);
  EXPECT_EQ(read("o/tracks.json"), list) << "nothing is touched";
  fs::remove(path("o/" + frameName(5) + "_labels.png"));
  expectFailure({frames(), "--frames", "5", "--out", path("o")}, 2, frameName(5) + "_overlay.png");
}

TEST_F(TrackCommand, NothingStaysOfAnEarlierRunOfTheSameFrames) {
  fs::copy(frames(), path("frames"));
  outputOf({path("frames"), "--frames", "6", "--overlays", "--out", path("o")});
  write("o/notes.txt", "mine");
  expectFailure(
      {path("frames"), "--frames", "6", "--poses", write("late.txt", "9 1 2 3 0 0 0 1\n"), "--out", path("o")}, 3,
      "none has the time of a frame");
  EXPECT_TRUE(exists("o/" + frameName(2) + "_overlay.png")) << "as long as there is nothing else";
  EXPECT_TRUE(exists("o/tracks.json"));
  write("frames/" + frameName(2) + "_depth.png", "no picture");
  EXPECT_EQ(run({path("frames"), "--frames", "6", "--out", path("o")}).exit_code, 3);
  EXPECT_FALSE(exists("o/" + frameName(2) + "_labels.png"));
  EXPECT_FALSE(exists("o/" + frameName(1) + "_overlay.png"));
  EXPECT_TRUE(exists("o/" + frameName(1) + "_labels.png"));
  EXPECT_EQ(read("o/notes.txt"), "mine");
}

TEST_F(TrackCommand, WhatIsNoNumberOrBelowNothingIsRefused) {
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--cell", "nan"},
                                                {"--rate", "nan"},
                                                {"--max-time-difference", "nan"},
                                                {"--first", "-1"}}) {
    std::vector<std::string> arguments = {frames(), "--out", path("o")};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    expectFailure(arguments, 2, wrong[0]);
  }
}

TEST_F(TrackCommand, TakesPosesOfAFile) {
  for (std::size_t i = 0; i < 8; ++i) {
    LabelledFrame frame = readLabelledFrame(frames(), frameName(i));
    frame.camera.extra.erase("pose");
    fs::create_directories(path("bare"));
    writeLabelledFrame(path("bare"), frame);
  }
  const std::string known = outputOf(
      {path("bare"), "--poses", frames() + "/groundtruth.txt", "--out", path("o"), "--measure", "--lags", "2"});
  EXPECT_NE(known.find("poses known"), std::string::npos);
  EXPECT_NE(known.find("labels as written"), std::string::npos);
  EXPECT_TRUE(readTrajectory(path("o/trajectory.txt"))[7].pose.isApprox(
      readTrajectory(frames() + "/groundtruth.txt")[7].pose, 0.02));
  const std::string free = outputOf({path("bare"), "--out", path("f"), "--measure"});
  EXPECT_NE(free.find("poses found by the planes"), std::string::npos);
  EXPECT_NE(free.find("nothing measured"), std::string::npos);
  EXPECT_EQ(tracks("f")["frame"], "first camera");
  EXPECT_TRUE(readTrajectory(path("f/trajectory.txt"))[0].pose.isApprox(Eigen::Isometry3d::Identity(), 1e-6));
}

TEST_F(TrackCommand, TakesSequencesOfTum) {
  std::string poses = "# timestamp tx ty tz qx qy qz qw\n";
  for (const char* stamp : {"1305031102.160407", "1305031102.194330", "1305031102.226738", "1305031102.262886"}) {
    Image<std::uint16_t> depth(640, 480, 10000);  // a wall two metres away
    fs::create_directories(path("seq/depth"));
    writeGray16(path(std::string("seq/depth/") + stamp + ".png"), depth);
    poses += std::to_string(std::stod(stamp) + 0.009) + " 1 2 3 0 0 0 1\n";
  }
  fs::create_directories(path("seq/rgb"));
  const std::string file = write("seq/groundtruth.txt", poses);
  const std::string out = outputOf({"tum-fr1:" + path("seq"), "--poses", file, "--out", path("o")});
  EXPECT_NE(out.find("poses known"), std::string::npos) << out;
  const Trajectory found = readTrajectory(path("o/trajectory.txt"));
  ASSERT_EQ(found.size(), 4U);
  EXPECT_DOUBLE_EQ(found[0].time, 1305031102.160407);
  EXPECT_TRUE(found[3].pose.translation().isApprox(Eigen::Vector3d(1, 2, 3), 1e-3));
  EXPECT_NEAR(tracks("o")["tracks"][0]["coefficients"][3].get<double>(), 5.0, 0.01) << "z = 3 + 2";
  expectFailure({"tum-fr1:" + path("seq"), "--poses", file, "--max-time-difference", "0.001", "--out", path("s")}, 3,
                "none has the time of a frame");
  const std::string late = write("late.txt", "1305031102.2 1 2 3 0 0 0 1\n1305031102.23 1 2 3 0 0 0 1\n");
  const std::string rest = outputOf({"tum-fr1:" + path("seq"), "--poses", late, "--out", path("r")});
  EXPECT_NE(rest.find("3 frames of"), std::string::npos) << rest;
  EXPECT_NE(rest.find("1 frames left out"), std::string::npos) << rest;
}

TEST_F(TrackCommand, FindsThePosesItself) {
  const std::string out = outputOf({frames(), "--pose-free", "--frames", "12", "--out", path("o")});
  EXPECT_NE(out.find("poses found by the planes"), std::string::npos);
  const Trajectory found = readTrajectory(path("o/trajectory.txt")),
                   truth = readTrajectory(frames() + "/groundtruth.txt");
  ASSERT_EQ(found.size(), 12U);
  EXPECT_TRUE(found[0].pose.isApprox(truth[0].pose, 1e-3)) << "the first is the map's frame";
  EXPECT_LT((found[11].pose.translation() - truth[11].pose.translation()).norm(), 0.05);
}

TEST_F(TrackCommand, FollowsARealTable) {
  EPCC_NEED_REAL_FRAMES("sequence");
  outputOf({realFolder("sequence"), "--frames", "60", "--out", path("o")});
  std::vector<double> areas;
  const nlohmann::json list = tracks("o");
  for (const nlohmann::json& track : list["tracks"])
    if (track["end"] == "none" && track["frames"].get<int>() >= 55) areas.push_back(track["area"].get<double>());
  ASSERT_GE(areas.size(), 3U) << "table, walls and more, seen all the time";
  EXPECT_GT(*std::max_element(areas.begin(), areas.end()), 0.4);
}

TEST_F(TrackCommand, ChoosesFrames) {
  const std::string out = outputOf({frames(), "--first", "3", "--every", "4", "--frames", "5", "--out", path("o")});
  EXPECT_NE(out.find("5 frames"), std::string::npos);
  EXPECT_TRUE(exists("o/" + frameName(3) + "_labels.png"));
  EXPECT_TRUE(exists("o/" + frameName(19) + "_labels.png"));
  EXPECT_FALSE(exists("o/" + frameName(23) + "_labels.png"));
}

TEST_F(TrackCommand, GivesTheSameForAnyNumberOfThreads) {
  for (const char* threads : {"1", "2"})
    outputOf({frames(), "--out", path(threads), "--frames", "10", "--threads", threads});
  for (const std::string file : {"tracks.json", "trajectory.txt", "map.png"})
    EXPECT_EQ(read("1/" + file), read("2/" + file)) << file;
}

TEST_F(TrackCommand, LeavesOutADamagedFrame) {
  fs::copy(frames(), path("damaged"));
  write("damaged/" + frameName(4) + "_depth.png", "no picture");
  const ToolResult result = run({path("damaged"), "--out", path("o")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_NE(result.err.find(frameName(4)), std::string::npos);
  EXPECT_NE(result.out.find("23 frames"), std::string::npos);
  EXPECT_FALSE(exists("o/" + frameName(4) + "_labels.png"));
}

TEST_F(TrackCommand, RefusesWrongCommandLines) {
  const std::string out = path("none");
  expectFailure({}, 2, "FOLDER");
  expectFailure({frames()}, 2, "--out");
  expectFailure({frames(), "--out", out, "--fast"}, 2, "--fast");
  expectFailure({frames(), "--out", out, "--every", "0"}, 2, "--every");
  expectFailure({frames(), "--out", out, "--pose-sigma", "1"}, 2, "METRES,DEGREES");
  expectFailure({frames(), "--out", out, "--pose-sigma", "-1,1"}, 2, "metres");
  expectFailure({frames(), "--out", out, "--motion-sigma", "1,100"}, 2, "degrees");
  expectFailure({frames(), "--out", out, "--projection", "camera"}, 2, "--projection");
  expectFailure({frames(), "--out", out, "--lags", "5,x"}, 2, "'x'");
  expectFailure({frames(), "--out", out, "--lags", "5,5"}, 2, "twice");
  expectFailure({frames(), "--out", out, "--set", "mode=paper"}, 2, "inverse-depth");
  expectFailure({frames(), "--out", out, "--set", "nothing=1"}, 2, "nothing");
  expectFailure({frames(), "--out", out, "--noise", "loud"}, 2, "loud");
  expectFailure({frames(), "--out", out, "--cell", "0"}, 2, "--cell");
  expectFailure({frames(), "--out", frames()}, 2, "holds the frames");
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(TrackCommand, SaysWhatCannotBeReadOrWritten) {
  expectFailure({path("missing"), "--out", path("o")}, 3, "missing");
  expectFailure({frames(), "--poses", path("missing.txt"), "--out", path("o")}, 3, "missing.txt");
  expectFailure({frames(), "--first", "24", "--out", path("o")}, 3, "--first 24");
  write("file", "x");
  expectFailure({frames(), "--out", path("file")}, 4, "file");
}

TEST_F(TrackCommand, HelpsAndNamesItsVersion) {
  EXPECT_NE(outputOf({"--help"}).find("--pose-free"), std::string::npos);
  EXPECT_EQ(outputOf({"--version"}).rfind("epcc_track ", 0), 0U);
}

}  // namespace
}  // namespace epcc::test
