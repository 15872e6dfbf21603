// SPDX-License-Identifier: BSD-3-Clause
// The ray caster on primitives whose depth can be worked out by hand.
#include "datasets/rendered/scene_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace epcc {
namespace {

// 5x5 pixels, one ray straight ahead, neighbours at slope 0.1.
const PinholeCamera kCamera{5, 5, 10.0, 10.0, 2.0, 2.0};

TEST(RenderPlane, FollowsEquation10) {
  const Eigen::Vector4d plane(0.0, -0.6, -0.8, 1.6);  // 0.6 y + 0.8 z = 1.6
  const DepthImage depth = renderPlane(plane, kCamera);
  EXPECT_FLOAT_EQ(depth.at(2, 2), 2.0F);
  EXPECT_FLOAT_EQ(depth.at(4, 0), static_cast<float>(1.6 / (0.8 + 0.6 * 0.2)));
}

TEST(RenderPlane, HasNoDepthBehindTheCamera) {
  const DepthImage behind = renderPlane({0.0, 0.0, 1.0, 2.0}, kCamera);  // z = -2
  EXPECT_EQ(std::count(behind.data.begin(), behind.data.end(), 0.0F), 25);
  const DepthImage floor = renderPlane({0.0, -1.0, 0.0, 1.0}, kCamera);  // y = 1: seen below the horizon only
  EXPECT_EQ(floor.at(2, 3), 0.0F);
  EXPECT_FLOAT_EQ(floor.at(3, 3), 10.0F);
}

TEST(RenderView, HitsTheNearSideOfASphere) {
  Scene scene;
  scene.spheres.push_back({{0.0, 3.0, 0.0}, 1.0});
  const SceneView view = renderView(scene, kCamera);
  EXPECT_FLOAT_EQ(view.depth.at(2, 2), 2.0F);
  EXPECT_EQ(view.surface.at(2, 2), kClutter);
}

TEST(RenderView, HitsSideAndCapOfACylinder) {
  Scene upright;
  upright.cylinders.push_back({{0.0, 3.0, -1.0}, {0.0, 3.0, 1.0}, 0.5});
  EXPECT_FLOAT_EQ(renderView(upright, kCamera).depth.at(2, 2), 2.5F);
  Scene lying;
  lying.cylinders.push_back({{0.0, 4.0, 0.0}, {0.0, 6.0, 0.0}, 0.5});
  EXPECT_FLOAT_EQ(renderView(lying, kCamera).depth.at(2, 2), 4.0F);
  EXPECT_EQ(renderView(lying, kCamera).depth.at(0, 0), 0.0F);
}

TEST(RenderView, ShowsTheNearerPolygon) {
  Scene scene;
  const int far = scene.addSurface("far"), near = scene.addSurface("near");
  scene.addQuad(near, {-0.05, 1, -0.05}, {0.05, 1, -0.05}, {0.05, 1, 0.05}, {-0.05, 1, 0.05});
  scene.addQuad(far, {-9, 3, -9}, {9, 3, -9}, {9, 3, 9}, {-9, 3, 9});
  const SceneView view = renderView(scene, kCamera);
  EXPECT_EQ(view.surface.at(2, 2), near);
  EXPECT_FLOAT_EQ(view.depth.at(2, 2), 1.0F);
  EXPECT_EQ(std::count(view.surface.data.begin(), view.surface.data.end(), far), 24);
  EXPECT_FLOAT_EQ(view.depth.at(0, 4), 3.0F);
}

TEST(RenderView, ShowsPolygonsThatReachBehindTheCamera) {
  Scene scene;
  scene.addQuad(scene.addSurface("floor"), {-9, -5, -1}, {9, -5, -1}, {9, 50, -1}, {-9, 50, -1});
  const SceneView view = renderView(scene, kCamera);
  EXPECT_FLOAT_EQ(view.depth.at(4, 2), 5.0F);
  EXPECT_EQ(view.depth.at(1, 2), 0.0F);
}

TEST(CameraPose, TurnsLeftAndLooksDown) {
  CameraPose pose;
  EXPECT_TRUE(pose.toCamera({1, 2, 3}).isApprox(Eigen::Vector3d(1, -3, 2)));
  pose.yaw = 0.5;  // what lies to the left of straight ahead comes to the middle
  EXPECT_NEAR(pose.toCamera({-std::sin(0.5), std::cos(0.5), 0}).x(), 0.0, 1e-12);
  pose.yaw = 0.0;
  pose.pitch = 0.5;
  EXPECT_TRUE(pose.toCamera({0, std::cos(0.5), -std::sin(0.5)}).isApprox(Eigen::Vector3d(0, 0, 1)));
}

TEST(AddBox, NamesTheFacesThatTheCameraCanSee) {
  Scene scene;
  scene.pose.position = {0, 0, 2};
  scene.addBox("box", {{0, 3, 0}, {1, 1, 1}, 0.0});
  EXPECT_EQ(scene.surfaces, (std::vector<std::string>{"box front", "box top"}));
}

}  // namespace
}  // namespace epcc
