// SPDX-License-Identifier: BSD-3-Clause
// Pieces are triangulated on their planes; vertices with the same coordinates are one.
#include "epcc_segmentation/surface_mesh.h"

#include <Eigen/Geometry>
#include <new>
#include <unordered_map>

#include "geometry/flat_points.h"
#include "geometry/geos_shapes.h"
#include "geometry/piece_triangles.h"

namespace epcc {

namespace {

class MeshBuilder {
 public:
  explicit MeshBuilder(SurfaceMesh& mesh) : mesh_(mesh) {}

  void add(const SurfacePolygon& surface) {
    for (const SurfacePiece& piece : surface.pieces) {
      FlatPolygon flat{piece.outline.flat, {}};
      std::vector<Vector3> points = piece.outline.points;
      for (const SurfaceRing& hole : piece.holes) {
        flat.holes.push_back(hole.flat);
        points.insert(points.end(), hole.points.begin(), hole.points.end());
      }
      for (const auto& triangle : pieceTriangles(shapes_, flat)) {
        std::array<int, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = vertex(points[triangle[k]]);
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
        mesh_.triangles.push_back(corners);
        mesh_.labels.push_back(surface.label);
      }
    }
  }

 private:
  int vertex(const Vector3& point) {
    const auto [found, is_new] = numbers_.emplace(point, static_cast<int>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.push_back(point);
    return found->second;
  }

  SurfaceMesh& mesh_;
  GeosShapes shapes_;
  std::unordered_map<Vector3, int, BitsHash<Vector3>> numbers_;
};

}  // namespace

double SurfaceMesh::area(std::size_t triangle) const {
  const std::array<int, 3>& corners = triangles[triangle];
  const Eigen::Vector3d a = vertices[static_cast<std::size_t>(corners[0])];
  const Eigen::Vector3d b = vertices[static_cast<std::size_t>(corners[1])];
  const Eigen::Vector3d c = vertices[static_cast<std::size_t>(corners[2])];
  return 0.5 * (b - a).cross(c - a).norm();
}

double SurfaceMesh::totalArea(int label) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (label == 0 || labels[i] == label) sum += area(i);
  return sum;
}

SurfaceMesh surfaceMesh(const std::vector<SurfacePolygon>& surfaces) {
  SurfaceMesh mesh;
  try {
    MeshBuilder builder(mesh);
    for (const SurfacePolygon& surface : surfaces) builder.add(surface);
  } catch (const std::bad_alloc&) {
    mesh = SurfaceMesh();
    mesh.status = Status::OutOfMemory;
  }
  return mesh;
}

}  // namespace epcc
