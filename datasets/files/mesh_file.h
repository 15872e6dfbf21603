// SPDX-License-Identifier: BSD-3-Clause
// Triangle meshes as PLY or OBJ.
#pragma once

#include <string>
#include <vector>

#include "datasets/files/image.h"
#include "epcc_segmentation/surface_mesh.h"

namespace epcc {

/// How a PLY file holds its numbers; OBJ is text.
enum class MeshEncoding { Binary, Text };

/// Writes the mesh, whole or not at all, as PLY or as OBJ, which the name's ending says (.ply, .obj, also in capitals).
/// colors[k - 1] is that of the faces of label k. PLY: vertices x y z in float, metres; faces with vertex_indices, red
/// green blue and label. OBJ: one group and material `plane_K` a label, its colour in a comment for each, for OBJ keeps
/// colours in a second file. Throws OutputError.
void writeMesh(const std::string& path, const SurfaceMesh& mesh, const std::vector<Rgb>& colors,
               MeshEncoding encoding = MeshEncoding::Binary);

/// True if writeMesh() takes the name.
bool isMeshName(const std::string& path);

}  // namespace epcc
