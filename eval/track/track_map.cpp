// SPDX-License-Identifier: BSD-3-Clause
// Footprints of pixels fill the cells of their track's plane; the cells' outlines are its polygons.
#include "eval/track/track_map.h"

#include <algorithm>
#include <cmath>

#include "eval/track/grid_outline.h"

namespace epcc {
namespace {

constexpr int kSamplesAlong = 80;        // of an image's width
constexpr double kSmallestArea = 0.004;  // of a piece or hole, square metres
constexpr int kRowsInTurn = 3;           // a frame adds each third row of the raster, the next frame those below
constexpr int kFewFrames = 10;           // below, once seen is enough

/// Where the corners of a pixel of the raster meet the plane; false if it is seen too flatly.
bool footprintOf(const PinholeCamera& camera, const Eigen::Vector4d& plane, int row, int column, double half,
                 std::array<Eigen::Vector3d, 4>& corners) {
  constexpr std::array<double, 4> kAcross = {-1, 1, 1, -1}, kDown = {-1, -1, 1, 1};
  double nearest = 1e300, farthest = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d ray((column + half * kAcross[i] - camera.cx) / camera.fx,
                              (row + half * kDown[i] - camera.cy) / camera.fy, 1.0);
    const double z = -plane(3) / plane.head<3>().dot(ray);
    if (!(z > 0.0 && std::isfinite(z))) return false;
    nearest = std::min(nearest, z);
    farthest = std::max(farthest, z);
    corners[i] = z * ray;
  }
  return farthest < 1.5 * nearest;
}

SurfaceRing ringOf(const std::vector<Eigen::Vector2d>& corners, const SurfaceGrid& grid, const PlaneBasis& basis) {
  SurfaceRing ring;
  for (const Eigen::Vector2d& corner : corners) {
    ring.flat.push_back(basis.flat(grid.basis().point(grid.cell() * corner)));
    ring.points.push_back(basis.point(ring.flat.back()));
  }
  return ring;
}

double perimeterOf(const SurfaceRing& ring) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.flat.size(); ++i)
    sum += (Eigen::Vector2d(ring.flat[i]) - Eigen::Vector2d(ring.flat[(i + 1) % ring.flat.size()])).norm();
  return sum;
}

/// The axes of the grid, laid onto the plane as it is known now.
PlaneBasis basisOn(const Eigen::Vector4d& plane, const PlaneBasis& old) {
  PlaneBasis basis;
  const Eigen::Vector3d normal = plane.head<3>(), origin = old.origin;
  basis.normal = normal;
  basis.origin = origin - normal * (normal.dot(origin) + plane(3));
  const Eigen::Vector3d across = old.across;
  basis.across = (across - normal * normal.dot(across)).normalized();
  basis.up = normal.cross(Eigen::Vector3d(basis.across));
  return basis;
}

SurfacePolygon polygonOf(const PlaneTrack& track, const SurfaceGrid& grid) {
  SurfacePolygon surface;
  surface.label = track.label;
  surface.basis = basisOn(track.plane.coefficients, grid.basis());
  const int least = track.frames < kFewFrames ? 1 : 2;
  const int min_cells = std::max(1, static_cast<int>(kSmallestArea / (grid.cell() * grid.cell())));
  for (const CellPiece& cells : cellPieces(grid.cells(least), min_cells)) {
    SurfacePiece piece;
    piece.outline = ringOf(cells.outline, grid, surface.basis);
    surface.area += piece.outline.signedArea();
    surface.perimeter += perimeterOf(piece.outline);
    for (const auto& hole : cells.holes) {
      piece.holes.push_back(ringOf(hole, grid, surface.basis));
      surface.area += piece.holes.back().signedArea();
      surface.perimeter += perimeterOf(piece.holes.back());
    }
    surface.pieces.push_back(std::move(piece));
  }
  return surface;
}

}  // namespace

std::map<int, int> finalLabels(const std::vector<PlaneTrack>& tracks) {
  std::map<int, int> into, final_labels;
  for (const PlaneTrack& track : tracks)
    if (track.end == TrackEnd::Merged && track.merged_into > 0) into[track.label] = track.merged_into;
  for (const PlaneTrack& track : tracks) {
    int label = track.label;
    for (std::size_t steps = 0; into.count(label) != 0 && steps <= into.size(); ++steps) label = into[label];
    final_labels[track.label] = label;
  }
  return final_labels;
}

void TrackMap::countPixels(const std::vector<std::int32_t>& labels) {
  long run = 0;  // neighbours mostly have the same label
  for (std::size_t i = 0; i < labels.size(); ++i) {
    ++run;
    if (i + 1 < labels.size() && labels[i + 1] == labels[i]) continue;
    if (labels[i] > 0) pixels_[labels[i]] += run;
    run = 0;
  }
}

void TrackMap::add(const LabelledFrame& frame, const TrackedFrame& tracked) {
  frames_ = (frames_ + 1) % kRowsInTurn;
  const PinholeCamera& camera = frame.camera.camera;
  const Eigen::Isometry3d to_map(tracked.pose.camera_to_map);
  const Eigen::Matrix4d plane_to_map = to_map.matrix().inverse().transpose();
  countPixels(tracked.labels);
  const int step = std::max(1, camera.width / kSamplesAlong);
  std::array<Eigen::Vector3d, 4> corners;
  for (int row = step / 2 + frames_ * step; row < camera.height; row += kRowsInTurn * step)
    for (int column = step / 2; column < camera.width; column += step) {
      const std::size_t i =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(camera.width) + static_cast<std::size_t>(column);
      const std::int32_t label = tracked.labels[i];
      if (label <= 0) continue;
      const Plane& plane = tracked.segmentation.planes[static_cast<std::size_t>(tracked.segmentation.labels[i]) - 1];
      if (!footprintOf(camera, plane.coefficients, row, column, 0.5 * step, corners)) continue;
      for (Eigen::Vector3d& corner : corners) corner = to_map * corner;
      auto grid = grids_.find(label);
      if (grid == grids_.end()) {
        const Eigen::Vector4d in_map = plane_to_map * Eigen::Vector4d(plane.coefficients);
        grid = grids_.emplace(label, SurfaceGrid(in_map, corners[0], cell_)).first;
      }
      grid->second.add(corners);
    }
}

std::vector<MappedTrack> TrackMap::tracks(const std::vector<PlaneTrack>& tracks) const {
  const std::map<int, int> now = finalLabels(tracks);
  std::map<int, std::vector<int>> parts;
  for (const auto& [label, final_label] : now)
    if (label != final_label) parts[final_label].push_back(label);
  std::vector<MappedTrack> mapped;
  for (const PlaneTrack& track : tracks) {
    MappedTrack one;
    one.track = track;
    one.surface.label = track.label;
    const auto pixels = pixels_.find(track.label);
    if (pixels != pixels_.end()) one.pixels = pixels->second;
    const auto grid = grids_.find(track.label);
    if (grid != grids_.end()) {
      SurfaceGrid whole = grid->second;
      for (const int part : parts[track.label]) {
        const auto of_part = grids_.find(part);
        if (of_part != grids_.end()) whole.add(of_part->second);
      }
      one.surface = polygonOf(track, whole);
    }
    mapped.push_back(std::move(one));
  }
  return mapped;
}

}  // namespace epcc
