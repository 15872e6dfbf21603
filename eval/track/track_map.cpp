// SPDX-License-Identifier: BSD-3-Clause
// Footprints of pixels fill the cells of their track's plane; the cells' outlines are its polygons.
#include "eval/track/track_map.h"

#include <algorithm>
#include <cmath>

#include "eval/track/contested_cells.h"
#include "eval/track/grid_outline.h"
#include "eval/track/plane_blocks.h"

namespace epcc {
namespace {

constexpr int kSamplesAlong = 80;        // of an image's width
constexpr double kSmallestArea = 0.004;  // of a piece or hole, square metres
constexpr int kTurns = 3;                // a frame adds each third row of the raster, the next frame those below
constexpr int kFewFrames = 10;           // below, once seen is enough

int stepOf(const PinholeCamera& camera) {
  return std::max(1, camera.width / kSamplesAlong);
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

/// Of each label itself, the one that its track became part of, the one that this became part of, and so on.
std::map<int, std::vector<int>> chains(const std::vector<PlaneTrack>& tracks) {
  std::map<int, int> into;
  for (const PlaneTrack& track : tracks)
    if (track.end == TrackEnd::Merged && track.merged_into > 0) into[track.label] = track.merged_into;
  std::map<int, std::vector<int>> chains;
  for (const PlaneTrack& track : tracks) {
    std::vector<int>& chain = chains[track.label];
    chain = {track.label};
    while (into.count(chain.back()) != 0 && chain.size() <= into.size()) chain.push_back(into[chain.back()]);
  }
  return chains;
}

}  // namespace

std::map<int, int> finalLabels(const std::vector<PlaneTrack>& tracks) {
  std::map<int, int> final_labels;
  for (const auto& [label, chain] : chains(tracks)) final_labels[label] = chain.back();
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

void TrackMap::add(const LabelledFrame& frame, const TrackedFrame& tracked, const SensorModel& sensor) {
  turn_ = (turn_ + 1) % kTurns;
  countPixels(tracked.labels);
  const PinholeCamera& camera = frame.camera.camera;
  const std::vector<PlaneBlock> blocks =
      planeBlocks(tracked.segmentation.labels, camera.width, camera.height, stepOf(camera), turn_, kTurns);
  for (const PlaneBlock& block : blocks) add(block, frame, tracked, sensor);
}

void TrackMap::add(const PlaneBlock& block, const LabelledFrame& frame, const TrackedFrame& tracked,
                   const SensorModel& sensor) {
  const std::size_t own = static_cast<std::size_t>(block.plane) - 1;
  const std::int32_t label = tracked.label_of_plane[own];
  if (label <= 0) return;
  addTo(gridOf(label, tracked, own), block, frame.camera.camera, tracked, own);

  const int row = (block.top + block.bottom) / 2, column = (block.left + block.right) / 2;
  const double depth = frame.depth.at(row, column);
  if (!(depth > 0.0)) return;
  const auto distance = [&](std::size_t plane) {  // of what was measured, in inverse depth
    const Eigen::Vector4d q = tracked.segmentation.planes[plane].coefficients;
    const PinholeCamera& camera = frame.camera.camera;
    const Eigen::Vector3d ray((column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy, 1.0);
    return std::abs(-q.head<3>().dot(ray) / q(3) - 1.0 / depth);
  };
  const double own_distance = distance(own), range = range_ * sensor.sigmaInverseDepth(depth);
  for (std::size_t plane = 0; plane < tracked.label_of_plane.size(); ++plane) {
    const std::int32_t other = tracked.label_of_plane[plane];
    if (other <= 0 || other == label) continue;
    // Nearer to the other plane than to its own it says nothing against that one.
    const double other_distance = distance(plane);
    if (other_distance > range || other_distance < own_distance) continue;
    auto seen_as = seen_as_.find({other, label});
    if (seen_as == seen_as_.end())
      seen_as = seen_as_.emplace(std::pair(other, label), gridOf(other, tracked, plane).blank()).first;
    addTo(seen_as->second, block, frame.camera.camera, tracked, plane);
  }
}

/// Where the pixels of a block are on a plane of the frame, whether or not they are that plane's.
void TrackMap::addTo(SurfaceGrid& grid, const PlaneBlock& block, const PinholeCamera& camera,
                     const TrackedFrame& tracked, std::size_t plane) {
  const auto footprint = [&](const PlaneBlock& pixels) {
    auto corners = footprintOf(pixels, camera, tracked.segmentation.planes[plane].coefficients);
    if (corners)
      for (Eigen::Vector3d& corner : *corners) corner = tracked.pose.camera_to_map * corner;
    return corners;
  };
  // What is seen too flatly as a square is so in parts, too.
  const auto square = footprint(squareAround(block, stepOf(camera)));
  if (!square || !grid.isFine(*square)) return;
  if (block.is_whole)
    grid.add(*square, true);
  else if (const auto part = footprint(block))
    grid.add(*part, false);
}

/// That of a label; a new one lies on the plane as this frame has it.
SurfaceGrid& TrackMap::gridOf(int label, const TrackedFrame& tracked, std::size_t plane) {
  const auto known = grids_.find(label);
  if (known != grids_.end()) return known->second;
  const Eigen::Isometry3d to_map(tracked.pose.camera_to_map);
  const Plane& own = tracked.segmentation.planes[plane];
  const Eigen::Vector4d in_map = to_map.matrix().inverse().transpose() * Eigen::Vector4d(own.coefficients);
  return grids_.emplace(label, SurfaceGrid(in_map, to_map * Eigen::Vector3d(own.centroid), cell_)).first->second;
}

/// What was seen of each track that goes on, with that of the tracks that became part of it.
std::map<int, ClaimedSurface> TrackMap::surfaces(const std::vector<PlaneTrack>& tracks) const {
  std::map<int, ClaimedSurface> surfaces;
  for (const PlaneTrack& track : tracks) {
    const auto grid = grids_.find(track.label);
    if (track.end == TrackEnd::None && grid != grids_.end())
      surfaces[track.label] = {track.plane.coefficients, grid->second, {}};
  }
  const std::map<int, int> now = finalLabels(tracks);
  for (const auto& [label, final_label] : now) {
    const auto part = grids_.find(label);
    const auto whole = surfaces.find(final_label);
    if (label != final_label && part != grids_.end() && whole != surfaces.end()) whole->second.seen.add(part->second);
  }
  for (const auto& [labels, seen] : seen_as_) {
    const int label = now.at(labels.first), other = now.at(labels.second);
    const auto surface = surfaces.find(label);
    if (label == other || surface == surfaces.end() || surfaces.count(other) == 0) continue;
    surface->second.seen_as.emplace(other, surface->second.seen.blank()).first->second.add(seen);
  }
  return surfaces;
}

std::vector<MappedTrack> TrackMap::tracks(const std::vector<PlaneTrack>& tracks) const {
  std::map<int, ClaimedSurface> going_on = surfaces(tracks);
  settleContested(going_on);
  std::map<int, long> pixels;
  for (const auto& [label, chain] : chains(tracks)) {
    const auto own = pixels_.find(label);
    if (own == pixels_.end()) continue;
    for (const int whole : chain) pixels[whole] += own->second;
  }
  std::vector<MappedTrack> mapped;
  for (const PlaneTrack& track : tracks) {
    MappedTrack one;
    one.track = track;
    one.pixels = pixels[track.label];
    one.surface.label = track.label;
    const auto surface = going_on.find(track.label);
    const auto grid = grids_.find(track.label);
    if (surface != going_on.end())
      one.surface = polygonOf(track, surface->second.seen);
    else if (grid != grids_.end())
      one.surface = polygonOf(track, grid->second);
    mapped.push_back(std::move(one));
  }
  return mapped;
}

}  // namespace epcc
