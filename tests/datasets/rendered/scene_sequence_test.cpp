// SPDX-License-Identifier: BSD-3-Clause
// Sequences: poses that are true, surfaces that keep their number, error that stays and error that does not.
#include "datasets/rendered/scene_sequence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "datasets/files/frame_pose.h"
#include "datasets/rendered/camera_path.h"
#include "datasets/rendered/scene_frame.h"

namespace epcc::test {
namespace {

SequenceRecipe recipe(const std::string& scene, const std::string& path, std::size_t frames = 0, double rate = 2.0) {
  SequenceRecipe result;
  result.scene = scene;
  result.path = path;
  result.frames = frames;
  result.rate = rate;
  result.options.camera = sceneCamera(160, 90);
  return result;
}

/// Planes of a frame in the world, by number.
std::map<int, Eigen::Vector4d> planesInWorld(const LabelledFrame& frame) {
  const Eigen::Matrix4d to_world = framePose(frame)->matrix().inverse().transpose();
  std::map<int, Eigen::Vector4d> planes;
  for (const nlohmann::json& plane : frame.camera.extra.at("planes")) {
    Eigen::Vector4d c;
    for (int k = 0; k < 4; ++k) c(k) = plane["coefficients"][static_cast<std::size_t>(k)].get<double>();
    planes[plane["id"].get<int>()] = to_world * c;
  }
  return planes;
}

TEST(SceneSequence, BeginsWithTheSceneItself) {
  for (const std::string& path : pathNames()) {
    SequenceRecipe first = recipe("b", path, 1);
    const LabelledFrame frame = SceneSequence(first).frame(0), single = renderScene("b", 0, first.options);
    std::size_t other = 0;
    for (std::size_t i = 0; i < frame.depth.data.size(); ++i)
      other +=
          std::abs(frame.depth.data[i] - single.depth.data[i]) > 1e-4F || frame.labels.data[i] != single.labels.data[i];
    EXPECT_LT(other, 10U) << path << ": the same view, up to rounding at edges";
    EXPECT_EQ(frame.name, "b_000_" + path + "_000000");
  }
}

TEST(SceneSequence, ASurfaceKeepsItsNumber) {
  for (const std::string& scene : sceneNames())
    for (const std::string& path : pathNames()) {
      const SceneSequence sequence(recipe(scene, path, 21));
      std::map<int, Eigen::Vector4d> known;
      std::map<int, std::string> names;
      for (std::size_t i = 0; i < 21; i += 3) {
        const LabelledFrame frame = sequence.frame(i);
        for (const nlohmann::json& plane : frame.camera.extra.at("planes")) {
          const auto [name, is_new] = names.emplace(plane["id"].get<int>(), plane["name"].get<std::string>());
          EXPECT_TRUE(is_new || name->second == plane["name"]);
        }
        for (const auto& [id, plane] : planesInWorld(frame)) {
          const Eigen::Vector4d there = known.emplace(id, plane).first->second;
          EXPECT_LT(std::min((there - plane).norm(), (there + plane).norm()), 1e-6)
              << scene << ' ' << path << ' ' << id;
        }
      }
      EXPECT_GE(static_cast<int>(known.size()), sceneSurfaces(scene));
    }
}

TEST(SceneSequence, StaysInsideTheScene) {
  for (const std::string& scene : sceneNames())
    for (const std::string& path : pathNames()) {
      const SceneSequence sequence(recipe(scene, path, 20));
      for (std::size_t i = 0; i < 20; ++i) {
        const DepthImage depth = sequence.frame(i).depth;
        const auto seen = std::count_if(depth.data.begin(), depth.data.end(), [](float z) { return z > 0.15F; });
        EXPECT_GT(static_cast<double>(seen), 0.95 * static_cast<double>(depth.data.size()))
            << scene << ' ' << path << ' ' << i;
      }
    }
}

TEST(SceneSequence, LabelledPixelsLieOnTheirPlane) {
  const SceneSequence sequence(recipe("c", "walk", 11));
  const LabelledFrame frame = sequence.frame(10);
  const Eigen::Isometry3d pose = *framePose(frame);
  EXPECT_GT((pose.translation() - framePose(sequence.frame(0))->translation()).norm(), 0.3) << "it has walked";
  const auto planes = planesInWorld(frame);
  const PinholeCamera& camera = frame.camera.camera;
  long labelled = 0;
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) {
      const std::uint16_t label = frame.labels.at(row, column);
      if (label == 0 || label == kIgnoreLabel) continue;
      ++labelled;
      const Eigen::Vector3d ray((column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy, 1.0);
      const Eigen::Vector3d point = pose * (static_cast<double>(frame.depth.at(row, column)) * ray);
      const Eigen::Vector4d plane = planes.at(label);
      ASSERT_LT(std::abs(plane.head<3>().dot(point) + plane(3)), 1e-4);
    }
  EXPECT_GT(labelled, 10000);
}

TEST(SceneSequence, ShowsSidesThatTheFirstViewDoesNot) {
  Scene scene = sceneArrangement("b", 0);
  const std::size_t before = scene.surfaces.size();
  scene.showAllSides();
  EXPECT_EQ(scene.surfaces.size(), before + 6)
      << "three boxes with two sides turned away each, none of them the bottom";
  scene.showAllSides();
  EXPECT_EQ(scene.surfaces.size(), before + 6);
  for (const std::string& name : scene.surfaces) EXPECT_EQ(name.find("bottom"), std::string::npos);
}

TEST(SceneSequence, FollowsARecordedPath) {
  SequenceRecipe recorded = recipe("a", "");
  StampedPose start, end;
  start.time = 100.0;
  start.pose = Eigen::Translation3d(7, 8, 9) * Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX());
  end.time = 102.0;
  end.pose = start.pose * Eigen::Translation3d(0.0, 0.0, 0.2);
  recorded.recorded = {start, end};
  const SceneSequence sequence(recorded);
  ASSERT_EQ(sequence.trajectory().size(), 5U) << "two a second, both ends";
  const Eigen::Isometry3d first = sequence.trajectory()[0].pose;
  EXPECT_TRUE(first.isApprox(cameraToWorld(sceneArrangement("a", 0).pose), 1e-9));
  EXPECT_TRUE((first.inverse() * sequence.trajectory()[2].pose)
                  .isApprox(Eigen::Isometry3d(Eigen::Translation3d(0, 0, 0.1)), 1e-9));
  EXPECT_EQ(sequence.frame(4).camera.extra.at("timestamp"), 2.0);
}

/// Of the depth errors of two frames from nearly the same place: what they have in common, as a share of the variance.
double commonShare(double share) {
  SequenceRecipe noisy = recipe("a", "", 2);
  StampedPose start, end;
  end.time = 0.5;
  end.pose = Eigen::Translation3d(1e-6, 0.0, 0.0);
  noisy.recorded = {start, end};
  noisy.noise = parseNoise("white:0.01,0,0").value();
  noisy.lasting = {share, 0.05};
  const SceneSequence sequence(noisy);
  noisy.noise = {};
  noisy.lasting.share = 0.0;
  const SceneSequence exact(noisy);
  const LabelledFrame a = sequence.frame(0), b = sequence.frame(1), truth = exact.frame(0);
  double products = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < truth.depth.data.size(); ++i) {
    if (truth.labels.data[i] == 0 || truth.labels.data[i] == kIgnoreLabel) continue;
    const double ea = a.depth.data[i] - truth.depth.data[i], eb = b.depth.data[i] - truth.depth.data[i];
    products += ea * eb;
    squares += 0.5 * (ea * ea + eb * eb);
  }
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(truth.depth.data.size())), 0.01, 0.002) << "the same size in all";
  return products / squares;
}

TEST(SceneSequence, ErrorStaysWithTheSceneAsFarAsItIsTold) {
  EXPECT_NEAR(commonShare(0.0), 0.0, 0.03);
  EXPECT_NEAR(commonShare(0.5), 0.5, 0.1);
  EXPECT_NEAR(commonShare(1.0), 1.0, 0.01);
}

TEST(LastingError, IsAFieldOfUnitVarianceAndTheLength) {
  double variance = 0.0, near = 0.0, far = 0.0;
  constexpr int kFields = 400;
  for (int seed = 0; seed < kFields; ++seed) {
    const LastingError field(0.1, static_cast<std::uint64_t>(seed));
    const double here = field.at({1, 2, 3});
    variance += here * here / kFields;
    near += here * field.at({1.1, 2, 3}) / kFields;
    far += here * field.at({1, 2.5, 3}) / kFields;
  }
  EXPECT_NEAR(variance, 1.0, 0.25);
  EXPECT_NEAR(near / variance, std::exp(-0.5), 0.12);
  EXPECT_NEAR(far, 0.0, 0.2);
}

TEST(SceneSequence, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(SceneSequence(recipe("z", "sway")), std::invalid_argument);
  EXPECT_THROW(SceneSequence(recipe("a", "fly")), std::invalid_argument);
}

}  // namespace
}  // namespace epcc::test
