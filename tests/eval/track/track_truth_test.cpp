// SPDX-License-Identifier: BSD-3-Clause
// epcc_track against the truth of rendered sequences: its labels, its map, its measures.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "datasets/files/frame_pose.h"
#include "datasets/files/png_io.h"
#include "tests/eval/track/track_runs.h"

namespace epcc::test {
namespace {

namespace fs = std::filesystem;

class TrackTruth : public TrackRuns {};

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

TEST_F(TrackTruth, LargeSurfacesKeepTheirLabel) {
  outputOf({frames(), "--out", path("o")});
  std::map<int, std::set<int>> labels;
  for (std::size_t i = 5; i < kTrackedFrames; ++i)
    for (const auto& [surface, label] : holders(frames(), path("o"), i))
      if (surface == 1 || surface == 2) labels[surface].insert(label);
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[1].size(), 1U) << "the desk";
  EXPECT_EQ(labels[2].size(), 1U) << "the wall";
  EXPECT_EQ(labels[1].count(0) + labels[2].count(0), 0U);
  EXPECT_NE(labels[1], labels[2]);
}

// Planes are confirmed in their third frame.
TEST_F(TrackTruth, FramesInWhichAPlaneHadNoLabelYetGetItLater) {
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

TEST_F(TrackTruth, TheMapIsTrue) {
  outputOf({frames(), "--out", path("o")});
  const nlohmann::json list = tracks("o");
  EXPECT_EQ(list["version"], 1);
  EXPECT_EQ(list["frames"], kTrackedFrames);
  EXPECT_EQ(list["frame"], "world of the poses");
  const int desk = holders(frames(), path("o"), kTrackedFrames - 1).at(1);
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

TEST_F(TrackTruth, SurfacesOfTheMapEndAtEachOther) {
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

TEST_F(TrackTruth, MeasuresWithoutAndWithTheTracker) {
  const std::string out = outputOf({frames(), "--out", path("o"), "--compare-single", "--lags", "2,10"});
  for (const char* words : {"planes, frames one by one    2", "labels as written           10", "relative, over 1 s",
                            "against the truth", "squared errors of planes"})
    EXPECT_NE(out.find(words), std::string::npos) << words << '\n' << out;
}

TEST_F(TrackTruth, WatchesLabelsForASecondWhateverTheLags) {
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

TEST_F(TrackTruth, DepthImagesTellWhichPosesAreWrong) {
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

TEST_F(TrackTruth, ACameraThatIsLostIsTold) {
  // Without poses; after eight frames another camera's, somewhere else in the room.
  const SceneSequence elsewhere = [] {
    SequenceRecipe recipe;
    recipe.scene = "c";
    recipe.path = "walk";
    recipe.frames = 4;
    recipe.options.camera = sceneCamera(240, 135);
    recipe.noise = parseNoise("white:0.001,0.001,0").value();
    return SceneSequence(recipe);
  }();
  fs::create_directories(path("mixed"));
  for (std::size_t i = 0; i < 12; ++i) {
    LabelledFrame frame = i < 8 ? readLabelledFrame(frames(), frameName(i)) : elsewhere.frame(i - 8);
    frame.name = "f" + std::to_string(100 + i);
    frame.camera.extra.erase("pose");
    frame.camera.extra["timestamp"] = 0.1 * static_cast<double>(i);
    writeLabelledFrame(path("mixed"), frame);
  }
  const std::string out = outputOf({path("mixed"), "--out", path("o")});
  EXPECT_NE(out.find("f108 first: the camera may be lost"), std::string::npos) << out;
  EXPECT_EQ(outputOf({frames(), "--pose-free", "--out", path("p")}).find("lost"), std::string::npos);
}

TEST_F(TrackTruth, FramesThatShowNothingAreCounted) {
  fs::create_directories(path("dark"));
  for (std::size_t i = 0; i < 4; ++i) {
    LabelledFrame frame = readLabelledFrame(frames(), frameName(i));
    if (i >= 2) std::fill(frame.depth.data.begin(), frame.depth.data.end(), 0.0F);
    writeLabelledFrame(path("dark"), frame);
  }
  EXPECT_NE(outputOf({path("dark"), "--out", path("o")}).find("2 of the frames show nothing"), std::string::npos);
}

TEST_F(TrackTruth, WhatAKilledRunHasLeftIsRemoved) {
  fs::create_directories(path("o"));
  std::ofstream(path("o/.epcc-1-2-3-4.tmp")) << "half";
  outputOf({frames(), "--frames", "2", "--out", path("o")});
  EXPECT_FALSE(fs::exists(path("o/.epcc-1-2-3-4.tmp")));
}

}  // namespace
}  // namespace epcc::test
