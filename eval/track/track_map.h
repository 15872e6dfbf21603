// SPDX-License-Identifier: BSD-3-Clause
// The map: what has been seen of each track, as polygons on its plane.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "datasets/files/labelled_frame.h"
#include "epcc_segmentation/plane_tracker.h"
#include "epcc_segmentation/surface_polygon.h"
#include "eval/track/contested_cells.h"
#include "eval/track/plane_blocks.h"

namespace epcc {

/// A track as the files and pictures show it.
struct MappedTrack {
  PlaneTrack track;
  long pixels = 0;         ///< with its label, over all frames, and with those of the tracks that became part of it
  SurfacePolygon surface;  ///< in the map's frame; without pieces if nothing of it was seen well
};

/// The label that each label carries on as: that of the track that it turned out to be part of, and so on.
std::map<int, int> finalLabels(const std::vector<PlaneTrack>& tracks);

/// Grows by what each frame shows.
class TrackMap {
 public:
  /// Cells of `cell` metres. A pixel may belong to each plane that is within `range` standard deviations of it.
  TrackMap(double cell, double range) : cell_(cell), range_(range) {}

  /// What a frame shows of its planes, by their lasting labels: squares of pixels of a third of the image, other ones
  /// in turn, count with their footprints on their planes. `sensor` is the frame's.
  void add(const LabelledFrame& frame, const TrackedFrame& tracked, const SensorModel& sensor);

  /// All tracks with what was seen of each; one that became part of another gives it what it has. Of those that go on
  /// no two have the same place (settleContested()).
  std::vector<MappedTrack> tracks(const std::vector<PlaneTrack>& tracks) const;

 private:
  void countPixels(const std::vector<std::int32_t>& labels);
  void add(const PlaneBlock& block, const LabelledFrame& frame, const TrackedFrame& tracked, const SensorModel& sensor);
  static void addTo(SurfaceGrid& grid, const PlaneBlock& block, const PinholeCamera& camera,
                    const TrackedFrame& tracked, std::size_t plane);
  SurfaceGrid& gridOf(int label, const TrackedFrame& tracked, std::size_t plane);
  std::map<int, ClaimedSurface> surfaces(const std::vector<PlaneTrack>& tracks) const;

  double cell_, range_;
  std::map<int, SurfaceGrid> grids_;  // by label
  /// By two labels: what was seen as the second and might have been the first one's, on the cells of the first.
  std::map<std::pair<int, int>, SurfaceGrid> seen_as_;
  std::map<int, long> pixels_;
  int turn_ = 0;
};

}  // namespace epcc
