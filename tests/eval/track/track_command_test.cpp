// SPDX-License-Identifier: BSD-3-Clause
// epcc_track on rendered sequences: its files, its labels against the truth, its measures, and every wrong command
// line.
#include "eval/track/track_command.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "datasets/files/frame_pose.h"
#include "datasets/files/png_io.h"
#include "datasets/files/trajectory_file.h"
#include "datasets/rendered/scene_sequence.h"
#include "tests/support/real_frames.h"
#include "tests/support/run_tool.h"

namespace epcc::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFrames = 24;

/// A desk with a box, rendered once for all tests.
class TrackCommand : public TempFolderTest {
 protected:
  static void SetUpTestSuite() {
    frames_ = new TempFolder;
    SequenceRecipe recipe;
    recipe.scene = "a";
    recipe.path = "orbit";
    recipe.frames = kFrames;
    recipe.options.camera = sceneCamera(240, 135);
    recipe.noise = parseNoise("white:0.001,0.001,0").value();
    const SceneSequence sequence(recipe);
    for (std::size_t i = 0; i < kFrames; ++i) writeLabelledFrame(frames_->path(), sequence.frame(i));
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
    test::expectFailure(run(arguments), "epcc_track", code, words);
  }
  nlohmann::json tracks(const std::string& folder) { return nlohmann::json::parse(read(folder + "/tracks.json")); }

 private:
  static TempFolder* frames_;
};
TempFolder* TrackCommand::frames_ = nullptr;

std::string frameName(std::size_t i) {
  char text[40];
  std::snprintf(text, sizeof text, "a_000_orbit_%06zu", i);
  return text;
}

/// The label that most pixels of the surface have.
std::map<int, int> holders(const std::string& truth_folder, const std::string& folder, std::size_t i) {
  const LabelImage truth = readGray16(truth_folder + "/" + frameName(i) + "_labels.png");
  const LabelImage labels = readGray16(folder + "/" + frameName(i) + "_labels.png");
  std::map<int, std::map<int, int>> counts;
  for (std::size_t k = 0; k < truth.data.size(); ++k) ++counts[truth.data[k]][labels.data[k]];
  std::map<int, int> result;
  for (const auto& [surface, by_label] : counts)
    result[surface] = std::max_element(by_label.begin(), by_label.end(), [](const auto& a, const auto& b) {
                        return a.second < b.second;
                      })->first;
  return result;
}

/// The surface of a map that has the most area of those with this normal, and the corners of what holds it.
struct MapSurface {
  double area = 0.0;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
};
MapSurface largestSurface(const nlohmann::json& list, const Eigen::Vector3d& normal) {
  MapSurface largest;
  for (const nlohmann::json& track : list["tracks"]) {
    const std::vector<double> plane = track["coefficients"];
    if (normal.dot(Eigen::Vector3d(plane[0], plane[1], plane[2])) < 0.98 || track["area"] <= largest.area) continue;
    largest = MapSurface();
    largest.area = track["area"];
    for (const nlohmann::json& piece : track["pieces"])
      for (const std::vector<double> point : piece["outline"]) {
        largest.low = largest.low.cwiseMin(Eigen::Vector3d(point[0], point[1], point[2]));
        largest.high = largest.high.cwiseMax(Eigen::Vector3d(point[0], point[1], point[2]));
      }
  }
  return largest;
}

/// Square metres of a surface of the truth on its plane in the world, by the cells of 2 cm that its pixels meet.
double seenArea(const SceneSequence& sequence, std::size_t frames, std::uint16_t surface,
                const Eigen::Vector4d& plane) {
  constexpr double kTruthCell = 0.02;
  std::set<std::array<long, 3>> cells;
  for (std::size_t i = 0; i < frames; ++i) {
    const LabelledFrame frame = sequence.frame(i);
    const PinholeCamera& camera = frame.camera.camera;
    const Eigen::Isometry3d pose = sequence.trajectory()[i].pose;
    for (int row = 0; row < camera.height; ++row)
      for (int column = 0; column < camera.width; ++column) {
        if (frame.labels.at(row, column) != surface) continue;
        const Eigen::Vector3d ray =
            pose.linear() * Eigen::Vector3d((column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy, 1.0);
        const Eigen::Vector3d start = pose.translation();
        const double z = -(plane.head<3>().dot(start) + plane(3)) / plane.head<3>().dot(ray);
        const Eigen::Vector3d cell = (start + z * ray) / kTruthCell;
        cells.insert({std::lround(cell.x()), std::lround(cell.y()), std::lround(cell.z())});
      }
  }
  return kTruthCell * kTruthCell * static_cast<double>(cells.size());
}

TEST_F(TrackCommand, LeavesAllItsFiles) {
  const std::string out = outputOf({frames(), "--out", path("o"), "--overlays"});
  EXPECT_NE(out.find("24 frames"), std::string::npos) << out;
  EXPECT_NE(out.find("poses known"), std::string::npos) << out;
  std::vector<std::string> expected = {"map.png", "times.csv", "tracks.json", "trajectory.txt"};
#ifdef EPCC_WITH_GEOS
  expected.push_back("map.ply");
#endif
  for (std::size_t i = 0; i < kFrames; ++i)
    for (const char* ending : {"_labels.png", "_overlay.png"}) expected.push_back(frameName(i) + ending);
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(names("o"), expected);
  const Trajectory trajectory = readTrajectory(path("o/trajectory.txt"));
  EXPECT_EQ(trajectory.size(), kFrames);
  const std::string times = read("o/times.csv");
  EXPECT_EQ(std::count(times.begin(), times.end(), '\n'), static_cast<long>(kFrames) + 1);
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

TEST_F(TrackCommand, LargeSurfacesKeepTheirLabel) {
  outputOf({frames(), "--out", path("o")});
  std::map<int, std::set<int>> labels;
  for (std::size_t i = 5; i < kFrames; ++i)
    for (const auto& [surface, label] : holders(frames(), path("o"), i))
      if (surface == 1 || surface == 2) labels[surface].insert(label);
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[1].size(), 1U) << "the desk";
  EXPECT_EQ(labels[2].size(), 1U) << "the wall";
  EXPECT_EQ(labels[1].count(0) + labels[2].count(0), 0U);
  EXPECT_NE(labels[1], labels[2]);
}

// Planes are confirmed in their third frame.
TEST_F(TrackCommand, FramesInWhichAPlaneHadNoLabelYetGetItLater) {
  outputOf({frames(), "--out", path("o")});
  outputOf({frames(), "--online", "--out", path("online")});
  const auto image = [&](const char* folder, std::size_t frame) {
    return readGray16(path((fs::path(folder) / (frameName(frame) + "_labels.png")).string()));
  };
  const LabelImage known = image("o", 0), third = image("o", 2);
  const auto labelled = [](const LabelImage& labels) {
    return std::count_if(labels.data.begin(), labels.data.end(), [](std::uint16_t label) { return label > 0; });
  };
  EXPECT_GT(labelled(known), labelled(third) * 98 / 100);
  for (const std::uint16_t label : known.data) EXPECT_LE(label, 9);
  EXPECT_EQ(labelled(image("online", 0)), 0);
  EXPECT_EQ(labelled(image("online", 1)), 0);
  EXPECT_EQ(image("online", 20).data, image("o", 20).data);
}

TEST_F(TrackCommand, TheMapIsTrue) {
  outputOf({frames(), "--out", path("o")});
  const nlohmann::json list = tracks("o");
  EXPECT_EQ(list["version"], 1);
  EXPECT_EQ(list["frames"], kFrames);
  EXPECT_EQ(list["frame"], "world of the poses");
  const int desk = holders(frames(), path("o"), kFrames - 1).at(1);
  bool found = false;
  for (const nlohmann::json& track : list["tracks"]) {
    if (track["label"] != desk) continue;
    found = true;
    EXPECT_NEAR(track["coefficients"][2].get<double>(), 1.0, 0.001) << "the desk lies";
    EXPECT_NEAR(track["coefficients"][3].get<double>(), 0.0, 0.01) << "at z = 0";
    EXPECT_EQ(track["end"], "none");
    EXPECT_GE(track["frames"].get<int>(), 20);
    EXPECT_GT(track["area"].get<double>(), 0.5);
    EXPECT_LT(track["area"].get<double>(), 6.0);
    double deepest = 0.0;
    for (const nlohmann::json& point : track["pieces"][0]["outline"])
      deepest = std::max(deepest, std::abs(point[2].get<double>()));
    EXPECT_LT(deepest, 0.02);
  }
  EXPECT_TRUE(found);
}

TEST_F(TrackCommand, SurfacesOfTheMapEndAtEachOther) {
  SequenceRecipe recipe;
  recipe.scene = "c";
  recipe.path = "walk";
  recipe.frames = 40;
  recipe.options.camera = sceneCamera(240, 135);
  recipe.noise = parseNoise("white:0.002,0.002,0").value();
  const SceneSequence sequence(recipe);
  fs::create_directories(path("room"));
  for (std::size_t i = 0; i < recipe.frames; ++i) writeLabelledFrame(path("room"), sequence.frame(i));
  outputOf({path("room"), "--out", path("o")});
  const MapSurface floor = largestSurface(tracks("o"), Eigen::Vector3d::UnitZ()),
                   wall = largestSurface(tracks("o"), -Eigen::Vector3d::UnitY());
  EXPECT_GT(wall.low.z(), floor.low.z() - 0.04) << "two cells: lines are drawn simpler by one";
  const double floor_share = floor.area / seenArea(sequence, recipe.frames, 1, {0, 0, 1, 0}),
               wall_share = wall.area / seenArea(sequence, recipe.frames, 2, {0, 1, 0, -wall.high.y()});
  EXPECT_GT(floor_share, 0.97);
  EXPECT_LT(floor_share, 1.05);
  EXPECT_GT(wall_share, 0.97);
  EXPECT_LT(wall_share, 1.03);
}

TEST_F(TrackCommand, MeasuresWithoutAndWithTheTracker) {
  const std::string out = outputOf({frames(), "--out", path("o"), "--compare-single", "--lags", "2,10"});
  for (const char* words : {"planes, frames one by one    2", "labels as written           10", "relative, over 1 s",
                            "against the truth", "squared errors of planes"})
    EXPECT_NE(out.find(words), std::string::npos) << words << '\n' << out;
}

TEST_F(TrackCommand, WatchesLabelsForASecondWhateverTheLags) {
  for (std::size_t i = 0; i < 8; ++i) {
    LabelledFrame frame = readLabelledFrame(frames(), frameName(i));
    frame.camera.extra["timestamp"] = 0.25 * static_cast<double>(i);
    fs::create_directories(path("slow"));
    writeLabelledFrame(path("slow"), frame);
  }
  // Frames 4 to 7 against 0 to 3: four seconds of each surface.
  const std::string out = outputOf({path("slow"), "--out", path("o"), "--measure", "--lags", "1", "--confirm", "1"});
  EXPECT_NE(out.find("of the largest five over 1 s: 0.00 as written, 0.00 as known by then (0."), std::string::npos)
      << out;
  EXPECT_EQ(out.find("(0.0 minutes)"), std::string::npos) << out;
}

// The median of a row of the table of relative poses.
double medianOfRow(const std::string& out, const std::string& row) {
  const std::size_t begin = out.find("\n" + row);
  EXPECT_NE(begin, std::string::npos) << row << '\n' << out;
  if (begin == std::string::npos) return -1.0;
  std::istringstream cells(out.substr(begin + 1 + row.size()));
  double rmse = -1.0, mean = -1.0, median = -1.0;
  cells >> rmse >> mean >> median;
  return median;
}

TEST_F(TrackCommand, DepthImagesTellWhichPosesAreWrong) {
  for (std::size_t i = 0; i < 11; ++i) {  // five a second: every pair is of an even frame and an odd one
    LabelledFrame frame = readLabelledFrame(frames(), frameName(i));
    Eigen::Isometry3d pose = framePose(frame).value();
    if (i % 2 == 1) pose.translation() += Eigen::Vector3d(0.04, 0.0, 0.03);
    setFramePose(pose, frame);
    frame.camera.extra["timestamp"] = 0.2 * static_cast<double>(i);
    fs::create_directories(path("wrong"));
    writeLabelledFrame(path("wrong"), frame);
  }
  const std::string out = outputOf({path("wrong"), "--pose-free", "--out", path("o"), "--measure", "--lags", "1"});
  EXPECT_NEAR(medianOfRow(out, "known poses, mm"), 50.0, 5.0) << out;
  EXPECT_LT(medianOfRow(out, "trajectory, mm"), 5.0) << out;
  EXPECT_LT(medianOfRow(out, "trajectory, degrees"), 0.3) << out;
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
