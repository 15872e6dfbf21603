// SPDX-License-Identifier: BSD-3-Clause
// The map of a few frames made by hand: what tracks have that became part of another, in files and pictures too.
#include "eval/track/track_map.h"

#include <gtest/gtest.h>

#include "datasets/files/png_io.h"
#include "eval/track/map_picture.h"
#include "eval/track/track_files.h"
#include "tests/support/temp_folder.h"

namespace epcc::test {
namespace {

PlaneTrack mergedTrack(int label, int into, long first, long last) {
  PlaneTrack track;
  track.label = label;
  track.first_frame = first;
  track.last_frame = last;
  if (into > 0) {
    track.end = TrackEnd::Merged;
    track.merged_into = into;
  }
  return track;
}

TEST(FinalLabels, FollowTheTracksToTheirEnd) {
  const std::map<int, int> now =
      finalLabels({mergedTrack(1, 0, 0, 9), mergedTrack(2, 1, 0, 4), mergedTrack(3, 2, 0, 2), mergedTrack(4, 0, 0, 9)});
  EXPECT_EQ(now, (std::map<int, int>{{1, 1}, {2, 1}, {3, 1}, {4, 4}}));
}

/// A wall two metres ahead, its left half of one plane and its right half of another.
TrackedFrame halves(const PinholeCamera& camera) {
  TrackedFrame tracked;
  tracked.segmentation.width = camera.width;
  tracked.segmentation.height = camera.height;
  tracked.segmentation.planes.resize(2);
  for (Plane& plane : tracked.segmentation.planes) {
    plane.coefficients << 0, 0, -1, 2;
    plane.centroid = Vector3(0, 0, 2);
  }
  tracked.label_of_plane = {1, 2};
  for (int i = 0; i < camera.width * camera.height; ++i)
    tracked.segmentation.labels.push_back(i % camera.width < camera.width / 2 ? 1 : 2);
  tracked.labels = tracked.segmentation.labels;
  return tracked;
}

TEST(TrackMap, WhatWasMergedIsPartOfTheOther) {
  LabelledFrame frame;
  PinholeCamera& camera = frame.camera.camera;
  camera.width = 160;
  camera.height = 120;
  camera.fx = camera.fy = 80;
  camera.cx = 79.5;
  camera.cy = 59.5;
  frame.depth = DepthImage(camera.width, camera.height, 2.0F);
  TrackMap map(0.02, 4.0);
  for (int i = 0; i < 6; ++i) map.add(frame, halves(camera), SensorModel::axial(0.001, 0.001));
  std::vector<PlaneTrack> tracks = {mergedTrack(1, 0, 0, 5), mergedTrack(2, 0, 0, 5), mergedTrack(3, 0, 0, 5)};
  for (PlaneTrack& track : tracks) track.plane.coefficients << 0, 0, -1, 2;
  for (PlaneTrack& track : tracks) track.frames = 6;
  const long half = 6L * 80 * 120;

  const std::vector<MappedTrack> apart = map.tracks(tracks);
  EXPECT_EQ(apart[0].pixels, half);
  EXPECT_EQ(apart[1].pixels, half);
  EXPECT_EQ(apart[2].pixels, 0);
  EXPECT_NEAR(apart[0].surface.area, 6.0, 0.2);
  EXPECT_NEAR(apart[1].surface.area, 6.0, 0.2);

  tracks[1].end = tracks[2].end = TrackEnd::Merged;
  tracks[1].merged_into = 3;
  tracks[2].merged_into = 1;
  const std::vector<MappedTrack> joined = map.tracks(tracks);
  EXPECT_EQ(joined[0].pixels, 2 * half);
  EXPECT_EQ(joined[1].pixels, half) << "what it had";
  EXPECT_EQ(joined[2].pixels, half) << "what it had when it was merged";
  EXPECT_NEAR(joined[0].surface.area, 12.0, 0.3);
}

class RewrittenLabels : public TempFolderTest {};

TEST_F(RewrittenLabels, BecomeThoseOfTheOther) {
  for (const char* name : {"x", "y", "z"})
    writeLastingLabels(path(std::string(name) + "_labels.png"), 4, 1, {0, 1, 2, 3});
  const std::vector<PlaneTrack> tracks = {mergedTrack(1, 0, 0, 2), mergedTrack(2, 1, 1, 1), mergedTrack(3, 0, 0, 2)};
  EXPECT_EQ(rewriteLabels(tracks, {"x", "y", "z"}, folder()), 1) << "only where it was seen";
  EXPECT_EQ(readGray16(path("x_labels.png")).data, (std::vector<std::uint16_t>{0, 1, 2, 3}));
  EXPECT_EQ(readGray16(path("y_labels.png")).data, (std::vector<std::uint16_t>{0, 1, 1, 3}));
}

TEST(MapPicture, ShowsWhatFacesTheViewer) {
  MappedTrack floor;
  floor.track.label = 3;
  floor.track.plane.coefficients << 0, 0, 1, 0;
  floor.surface.label = 3;
  floor.surface.basis.normal = Vector3::UnitZ();
  SurfacePiece piece;
  piece.outline.points = {Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(4, 2, 0), Vector3(0, 2, 0)};
  floor.surface.pieces = {piece};
  MappedTrack ceiling = floor;
  ceiling.track.label = 4;
  ceiling.track.plane.coefficients << 0, 0, -1, 3;
  ceiling.surface.basis.normal = -Vector3::UnitZ();
  for (Vector3& point : ceiling.surface.pieces[0].outline.points) point.z() = 3;
  const MapView above{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
  const auto colored = [&](const std::vector<MappedTrack>& tracks) {
    const ColorImage image = drawMap(tracks, {}, above, 400);
    return std::count_if(image.data.begin(), image.data.end(), [](const Rgb& c) { return c.r != c.g || c.g != c.b; });
  };
  EXPECT_GT(colored({floor}), 50000);
  EXPECT_EQ(colored({floor}), colored({floor, ceiling}));
  EXPECT_EQ(colored({ceiling}), 0);
  floor.track.end = TrackEnd::Clutter;
  EXPECT_EQ(colored({floor}), 0);
}

}  // namespace
}  // namespace epcc::test
