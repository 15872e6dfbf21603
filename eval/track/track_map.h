// SPDX-License-Identifier: BSD-3-Clause
// The map: what has been seen of each track, as polygons on its plane.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "datasets/files/labelled_frame.h"
#include "epcc_segmentation/plane_tracker.h"
#include "epcc_segmentation/surface_polygon.h"
#include "eval/track/surface_grid.h"

namespace epcc {

/// A track as the files and pictures show it.
struct MappedTrack {
  PlaneTrack track;
  long pixels = 0;         ///< with its label, over all frames
  SurfacePolygon surface;  ///< in the map's frame; without pieces if nothing of it was seen well
};

/// The label that each label carries on as: that of the track that it turned out to be part of, and so on.
std::map<int, int> finalLabels(const std::vector<PlaneTrack>& tracks);

/// Grows by what each frame shows.
class TrackMap {
 public:
  explicit TrackMap(double cell) : cell_(cell) {}

  /// What a frame shows of its planes, by their lasting labels. Pixels of a coarse raster, other ones in turn, count
  /// with their footprints on their planes.
  void add(const LabelledFrame& frame, const TrackedFrame& tracked);

  /// All tracks with what was seen of each; one that became part of another gives it what it has.
  std::vector<MappedTrack> tracks(const std::vector<PlaneTrack>& tracks) const;

 private:
  void countPixels(const std::vector<std::int32_t>& labels);

  double cell_;
  std::map<int, SurfaceGrid> grids_;  // by label
  std::map<int, long> pixels_;
  int frames_ = 0;  ///< modulo the turns
};

}  // namespace epcc
