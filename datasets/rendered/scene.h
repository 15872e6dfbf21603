// SPDX-License-Identifier: BSD-3-Clause
// Rendered scenes with exact labels: the surrogates of the paper's four scenes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "datasets/files/labelled_frame.h"
#include "epcc_segmentation/depth_frame.h"

namespace epcc {

/// D435i-like depth camera: 480x270, 90 degrees wide, fx = fy = 240 px.
PinholeCamera sceneCamera();
/// The same field of view on another grid.
PinholeCamera sceneCamera(int width, int height);

struct SceneOptions {
  PinholeCamera camera = sceneCamera();
  /// Surfaces seen with fewer pixels are labelled "ignore". Pixels of a 480x270 image; scales with the image's area.
  int min_surface_pixels = 300;
};

/// "a", "b", "c", "d".
std::vector<std::string> sceneNames();
/// N: planes visible in every rendering with the default camera (5, 11, 9, 9); 0 for an unknown name.
int sceneSurfaces(const std::string& name);

/// Renders one arrangement of a scene, free of noise. Each seed moves the camera and the objects a little; arrangements
/// in which a surface is hidden or falls apart are drawn again, so that N is the same for every seed. One label a
/// plane: at least 95 % of a surface's pixels form one piece in the default view, the rest keeps the same label.
/// camera.extra["planes"] lists id, name, pixels and coefficients (a, b, c, d), camera frame, metres, d > 0.
/// Throws std::invalid_argument if the name is unknown or the camera cannot be used.
LabelledFrame renderScene(const std::string& name, std::uint64_t seed, const SceneOptions& options = {});

}  // namespace epcc
