// SPDX-License-Identifier: BSD-3-Clause
// The two steps of a rendering: an arrangement of a scene, and a view of it as a labelled frame.
#pragma once

#include <cstdint>
#include <string>

#include "datasets/rendered/scene.h"
#include "datasets/rendered/scene_geometry.h"
#include "datasets/rendered/scene_renderer.h"

namespace epcc {

/// The arrangement that renderScene() shows for this seed; std::invalid_argument for an unknown name.
Scene sceneArrangement(const std::string& name, std::uint64_t seed);

/// "a_000" of the scene a and the seed 0.
std::string sceneFrameName(const std::string& name, std::uint64_t seed);

/// A view of it with labels and planes, as renderScene() gives it.
LabelledFrame sceneFrame(const std::string& name, std::uint64_t seed, const Scene& scene, const SceneView& view,
                         const SceneOptions& options);

}  // namespace epcc
