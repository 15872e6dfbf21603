// SPDX-License-Identifier: BSD-3-Clause
// Draws arrangements of a scene until all its surfaces can be seen, and makes a labelled frame of the view.
#include "datasets/rendered/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "datasets/rendered/scene_catalogue.h"
#include "datasets/rendered/scene_frame.h"
#include "datasets/rendered/scene_renderer.h"

namespace epcc {
namespace {

constexpr int kArrangements = 1000;      // draws before giving up
constexpr double kMinPieceShare = 0.95;  // of a surface, in one connected piece
constexpr double kDepthUnit = 0.0002;    // metres, finer than any sensor, up to 13 m in 16 bits
constexpr std::uint64_t kSceneStream = 1;

const SceneRecipe& recipeOf(const std::string& name) {
  for (const SceneRecipe& recipe : sceneRecipes())
    if (recipe.name == name) return recipe;
  throw std::invalid_argument("unknown scene '" + name + "'");
}

std::vector<int> pixelCounts(const SceneView& view) {
  std::vector<int> counts(view.planes.size(), 0);
  for (const int surface : view.surface.data)
    if (surface != kClutter) ++counts[static_cast<std::size_t>(surface)];
  return counts;
}

// Pixels of the 4-connected piece around a start pixel; marks them as clutter.
int takePiece(Image<int>& surface, int row, int column) {
  const int wanted = surface.at(row, column);
  std::vector<std::pair<int, int>> open{{row, column}};
  surface.at(row, column) = kClutter;
  int count = 0;
  const auto visit = [&](int r, int c) {
    if (r < 0 || c < 0 || r >= surface.height || c >= surface.width || surface.at(r, c) != wanted) return;
    surface.at(r, c) = kClutter;
    open.emplace_back(r, c);
  };
  while (!open.empty()) {
    const auto [r, c] = open.back();
    open.pop_back();
    ++count;
    visit(r - 1, c);
    visit(r + 1, c);
    visit(r, c - 1);
    visit(r, c + 1);
  }
  return count;
}

std::vector<int> largestPieces(const SceneView& view) {
  std::vector<int> largest(view.planes.size(), 0);
  Image<int> rest = view.surface;
  for (int row = 0; row < rest.height; ++row) {
    for (int column = 0; column < rest.width; ++column) {
      if (rest.at(row, column) == kClutter) continue;
      int& most = largest[static_cast<std::size_t>(rest.at(row, column))];
      most = std::max(most, takePiece(rest, row, column));
    }
  }
  return largest;
}

bool showsEverything(const Scene& scene, const SceneRecipe& recipe) {
  if (static_cast<int>(scene.surfaces.size()) != recipe.surfaces) return false;
  const SceneView view = renderView(scene, sceneCamera());
  const std::vector<int> counts = pixelCounts(view), largest = largestPieces(view);
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] < recipe.smallest || largest[i] < kMinPieceShare * counts[i]) return false;
  return std::all_of(view.depth.data.begin(), view.depth.data.end(), [](float z) { return z > 0.0F; });
}

LabelImage labelsOf(const SceneView& view, const std::vector<int>& counts, double min_pixels) {
  LabelImage labels(view.surface.width, view.surface.height);
  for (std::size_t i = 0; i < labels.data.size(); ++i) {
    const int surface = view.surface.data[i];
    if (surface == kClutter) continue;
    const bool large = counts[static_cast<std::size_t>(surface)] >= min_pixels;
    labels.data[i] = large ? static_cast<std::uint16_t>(surface + 1) : kIgnoreLabel;
  }
  return labels;
}

nlohmann::json planesJson(const Scene& scene, const SceneView& view, const std::vector<int>& counts,
                          double min_pixels) {
  nlohmann::json planes = nlohmann::json::array();
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    if (counts[i] < min_pixels) continue;
    const Eigen::Vector4d& p = view.planes[i];
    planes.push_back({{"id", i + 1},
                      {"name", scene.surfaces[i]},
                      {"pixels", counts[i]},
                      {"coefficients", {p(0), p(1), p(2), p(3)}}});
  }
  return planes;
}

}  // namespace

std::string sceneFrameName(const std::string& name, std::uint64_t seed) {
  char text[32];
  std::snprintf(text, sizeof text, "_%03llu", static_cast<unsigned long long>(seed));
  return name + text;
}

PinholeCamera sceneCamera() {
  return sceneCamera(480, 270);
}

PinholeCamera sceneCamera(int width, int height) {
  return {width, height, 0.5 * width, 0.5 * width, 0.5 * (width - 1), 0.5 * (height - 1)};
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const SceneRecipe& recipe : sceneRecipes()) names.push_back(recipe.name);
  return names;
}

int sceneSurfaces(const std::string& name) {
  for (const SceneRecipe& recipe : sceneRecipes())
    if (recipe.name == name) return recipe.surfaces;
  return 0;
}

Scene sceneArrangement(const std::string& name, std::uint64_t seed) {
  const SceneRecipe& recipe = recipeOf(name);
  SceneRandom random(seed, kSceneStream);
  for (int i = 0; i < kArrangements; ++i) {
    Scene scene = recipe.build(random);
    if (showsEverything(scene, recipe)) return scene;
  }
  throw std::runtime_error("scene '" + recipe.name + "': no arrangement shows all surfaces");
}

LabelledFrame sceneFrame(const std::string& name, std::uint64_t seed, const Scene& scene, const SceneView& view,
                         const SceneOptions& options) {
  const std::vector<int> counts = pixelCounts(view);
  const double area = static_cast<double>(options.camera.width) * options.camera.height / (480.0 * 270.0);
  const double min_pixels = std::max(1.0, options.min_surface_pixels * area);

  LabelledFrame frame;
  frame.name = sceneFrameName(name, seed);
  frame.camera.camera = options.camera;
  frame.camera.depth_scale = kDepthUnit;
  frame.camera.name = frame.name;
  frame.camera.noise = "rendered";
  frame.camera.extra = {{"scene", recipeOf(name).title}, {"seed", seed}};
  frame.camera.extra["planes"] = planesJson(scene, view, counts, min_pixels);
  frame.depth = view.depth;
  frame.labels = labelsOf(view, counts, min_pixels);
  return frame;
}

LabelledFrame renderScene(const std::string& name, std::uint64_t seed, const SceneOptions& options) {
  recipeOf(name);
  const std::string problem = options.camera.validate();
  if (!problem.empty()) throw std::invalid_argument(problem);
  const Scene scene = sceneArrangement(name, seed);
  return sceneFrame(name, seed, scene, renderView(scene, options.camera), options);
}

}  // namespace epcc
