// SPDX-License-Identifier: BSD-3-Clause
// The four scenes of the comparison: surrogates of the paper's desk, boxes, room and corridor.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "datasets/rendered/scene_geometry.h"
#include "datasets/support/scene_random.h"

namespace epcc {

/// A kind of scene; `build` draws one arrangement of it.
struct SceneRecipe {
  std::string name;
  std::string title;
  int surfaces;  ///< N: planes that are to be visible
  int smallest;  ///< pixels of 480x270 that each of them has at least
  std::function<Scene(SceneRandom&)> build;
};

/// (a) N = 5 near desk, (b) N = 11 boxes on a desk, (c) N = 9 larger room, (d) N = 9 corridor, up to 10 m deep.
const std::vector<SceneRecipe>& sceneRecipes();

}  // namespace epcc
