// SPDX-License-Identifier: BSD-3-Clause
// Builds the four scenes; lengths in metres, world frame x right, y forward, z up.
#include "datasets/rendered/scene_catalogue.h"

#include <cmath>

#include "datasets/support/degree.h"

namespace epcc {
namespace {

using Eigen::Vector3d;

CameraPose drawPose(SceneRandom& random, const Vector3d& position, double pitch_degrees) {
  CameraPose pose;
  pose.position =
      position + Vector3d(random.uniform(-0.04, 0.04), random.uniform(-0.04, 0.04), random.uniform(-0.03, 0.03));
  pose.yaw = kDegree * random.uniform(-3.0, 3.0);
  pose.pitch = kDegree * (pitch_degrees + random.uniform(-1.5, 1.5));
  pose.roll = kDegree * random.uniform(-2.0, 2.0);
  return pose;
}

// A box near (x, y), turned so that two sides show.
SceneBox drawBox(SceneRandom& random, double x, double y, const Vector3d& size, double yaw_low, double yaw_high) {
  SceneBox box;
  box.bottom = Vector3d(x + random.uniform(-0.04, 0.04), y + random.uniform(-0.04, 0.04), 0.0);
  box.size = size * random.uniform(0.92, 1.08);
  box.yaw = kDegree * random.uniform(yaw_low, yaw_high);
  return box;
}

void addFloor(Scene& scene, const char* name, double half_width, double from, double to) {
  scene.addQuad(scene.addSurface(name), {-half_width, from, 0}, {half_width, from, 0}, {half_width, to, 0},
                {-half_width, to, 0});
}

// Wall across the view at y = `at`.
void addCrossWall(Scene& scene, const char* name, double half_width, double at, double height) {
  scene.addQuad(scene.addSurface(name), {-half_width, at, 0}, {half_width, at, 0}, {half_width, at, height},
                {-half_width, at, height});
}

// Wall along the view at x = `at`.
void addSideWall(Scene& scene, const char* name, double at, double from, double to, double height) {
  scene.addQuad(scene.addSurface(name), {at, from, 0}, {at, to, 0}, {at, to, height}, {at, from, height});
}

Scene nearDesk(SceneRandom& random) {
  Scene scene;
  scene.pose = drawPose(random, {0, 0, 0.55}, 35.0);
  const double wall = random.uniform(1.10, 1.25);
  addFloor(scene, "desk", 3.0, -0.6, wall);
  addCrossWall(scene, "wall", 3.0, wall, 2.0);
  scene.addBox("box", drawBox(random, random.uniform(-0.15, 0.15), 0.66, {0.32, 0.26, 0.22}, 32.0, 58.0));
  return scene;
}

Scene boxesOnDesk(SceneRandom& random) {
  Scene scene;
  scene.pose = drawPose(random, {0, 0, 0.62}, 33.0);
  const double wall = random.uniform(1.40, 1.55);
  addFloor(scene, "desk", 3.0, -0.6, wall);
  addCrossWall(scene, "wall", 3.0, wall, 2.0);
  scene.addBox("left box", drawBox(random, -0.47, 0.86, {0.33, 0.28, 0.28}, 58.0, 84.0));
  scene.addBox("middle box", drawBox(random, 0.02, 0.58, {0.26, 0.20, 0.15}, -58.0, -32.0));
  scene.addBox("right box", drawBox(random, 0.50, 0.92, {0.32, 0.26, 0.34}, 4.0, 30.0));
  const double mug = random.uniform(-0.30, -0.22), bottle = random.uniform(0.04, 0.10);
  scene.cylinders.push_back({{mug, 0.55, 0.0}, {mug, 0.55, 0.10}, 0.040});
  scene.cylinders.push_back({{bottle, 1.05, 0.0}, {bottle, 1.05, 0.22}, 0.035});
  scene.cylinders.push_back({{bottle, 1.05, 0.22}, {bottle, 1.05, 0.29}, 0.014});
  scene.spheres.push_back({{random.uniform(0.32, 0.40), 0.56, 0.06}, 0.06});
  scene.cylinders.push_back({{-0.12, 1.12, 0.02}, {random.uniform(-0.28, -0.20), 1.18, 0.02}, 0.02});
  return scene;
}

Scene largeRoom(SceneRandom& random) {
  Scene scene;
  scene.pose = drawPose(random, {0, 0, 1.35}, 15.0);
  const double half = random.uniform(2.10, 2.25), back = random.uniform(4.5, 4.9), height = 3.2;
  addFloor(scene, "floor", half, -1.0, back);
  addCrossWall(scene, "back wall", half, back, height);
  addSideWall(scene, "left wall", -half, -1.0, back, height);
  addSideWall(scene, "right wall", half, -1.0, back, height);
  const double start = random.uniform(2.5, 2.8), length = random.uniform(1.1, 1.3);
  scene.addBox("cabinet", {{-half + 0.28, start + 0.5 * length, 0.0}, {0.56, length, 1.95}, 0.0});
  scene.addBox("chest", drawBox(random, random.uniform(0.6, 0.9), 2.75, {0.95, 0.60, 0.62}, 15.0, 42.0));
  scene.addChair({random.uniform(-0.65, -0.45), random.uniform(2.5, 2.8), 0.0}, kDegree * random.uniform(-50, 50));
  const double bin = random.uniform(3.9, 4.1);
  scene.cylinders.push_back({{half - 0.25, bin, 0.0}, {half - 0.25, bin, 0.38}, 0.15});
  scene.spheres.push_back({{random.uniform(-0.3, 0.0), random.uniform(3.7, 3.9), 0.13}, 0.13});
  return scene;
}

// The end wall around a doorway, and the leaf that stands open into the corridor.
void addDoor(Scene& scene, double half, double at, double height, double opening) {
  constexpr double kSide = 0.45, kTop = 2.05;
  const int wall = scene.addSurface("end wall");
  const auto part = [&](double left, double right, double low, double high) {
    scene.addQuad(wall, {left, at, low}, {right, at, low}, {right, at, high}, {left, at, high});
  };
  part(-half, -kSide, 0.0, height);
  part(kSide, half, 0.0, height);
  part(-kSide, kSide, kTop, height);
  const double x = -kSide + 2.0 * kSide * std::cos(opening), y = at - 2.0 * kSide * std::sin(opening);
  scene.addQuad(scene.addSurface("door leaf"), {-kSide, at, 0}, {x, y, 0}, {x, y, kTop}, {-kSide, at, kTop});
}

Scene corridor(SceneRandom& random) {
  Scene scene;
  scene.pose = drawPose(random, {0, 0, 1.40}, 3.0);
  const double half = random.uniform(0.98, 1.05), end = random.uniform(7.1, 7.6), height = 2.5;
  const double behind = end + random.uniform(1.8, 2.1);
  addFloor(scene, "floor", 3.0, -1.0, behind);
  scene.addQuad(scene.addSurface("ceiling"), {-half, -1, height}, {half, -1, height}, {half, end, height},
                {-half, end, height});
  addSideWall(scene, "left wall", -half, -1.0, end, height);
  addSideWall(scene, "right wall", half, -1.0, end, height);
  addDoor(scene, half, end, height, kDegree * random.uniform(112.0, 124.0));
  addCrossWall(scene, "wall behind the door", 3.0, behind, height);
  const double start = random.uniform(2.4, 2.8);
  scene.addBox("cabinet", {{half - 0.22, start + 0.6, 0.0}, {0.44, 1.2, 1.8}, 0.0});
  scene.addChair({-half + 0.38, random.uniform(3.0, 3.5), 0.0}, kDegree * random.uniform(60.0, 110.0));
  const double bin = random.uniform(4.6, 5.2);
  scene.cylinders.push_back({{half - 0.20, bin, 0.0}, {half - 0.20, bin, 0.45}, 0.15});
  scene.spheres.push_back({{random.uniform(-0.2, 0.1), random.uniform(3.6, 4.2), 0.11}, 0.11});
  return scene;
}

}  // namespace

const std::vector<SceneRecipe>& sceneRecipes() {
  static const std::vector<SceneRecipe> recipes = {
      {"a", "near desk", 5, 1200, nearDesk},
      {"b", "boxes and clutter on a desk", 11, 900, boxesOnDesk},
      {"c", "larger room", 9, 900, largeRoom},
      {"d", "corridor with a door at its end", 9, 900, corridor},
  };
  return recipes;
}

}  // namespace epcc
