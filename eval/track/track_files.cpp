// SPDX-License-Identifier: BSD-3-Clause
// Tracks as JSON, as triangles, and as label images.
#include "eval/track/track_files.h"

#include <algorithm>
#include <filesystem>
#include <set>

#ifdef EPCC_WITH_GEOS
#include "datasets/files/mesh_file.h"
#include "epcc_segmentation/surface_mesh.h"
#endif
#include "datasets/files/png_io.h"
#include "datasets/files/vector_json.h"
#include "datasets/support/input_error.h"
#include "eval/pictures/label_colors.h"

namespace epcc {
namespace {

nlohmann::json ringJson(const SurfaceRing& ring) {
  nlohmann::json json = nlohmann::json::array();
  for (const Vector3& point : ring.points) json.push_back(vectorJson(point));
  return json;
}

nlohmann::json piecesJson(const SurfacePolygon& surface) {
  nlohmann::json pieces = nlohmann::json::array();
  for (const SurfacePiece& piece : surface.pieces) {
    nlohmann::json holes = nlohmann::json::array();
    for (const SurfaceRing& hole : piece.holes) holes.push_back(ringJson(hole));
    pieces.push_back({{"outline", ringJson(piece.outline)}, {"holes", std::move(holes)}});
  }
  return pieces;
}

nlohmann::json covarianceJson(const Matrix4& covariance) {
  nlohmann::json rows = nlohmann::json::array();
  for (Eigen::Index row = 0; row < 4; ++row) rows.push_back(vectorJson(Vector4(covariance.row(row).transpose())));
  return rows;
}

nlohmann::json trackJson(const MappedTrack& one) {
  const PlaneTrack& track = one.track;
  nlohmann::json json = {{"label", track.label},
                         {"coefficients", vectorJson(track.plane.coefficients)},
                         {"coefficients_covariance", covarianceJson(track.plane.covariance)},
                         {"centroid", vectorJson(track.centroid)},
                         {"first_frame", track.first_frame},
                         {"last_frame", track.last_frame},
                         {"first_time", track.first_time},
                         {"last_time", track.last_time},
                         {"frames", track.frames},
                         {"pixels", one.pixels},
                         {"confidence", track.confidence},
                         {"end", inWords(track.end)},
                         {"area", one.surface.area},
                         {"pieces", piecesJson(one.surface)}};
  if (track.end == TrackEnd::Merged) json["merged_into"] = track.merged_into;
  return json;
}

}  // namespace

nlohmann::json trackListJson(const std::vector<MappedTrack>& tracks, bool poses_given, long frames) {
  nlohmann::json list = nlohmann::json::array();
  for (const MappedTrack& one : tracks) list.push_back(trackJson(one));
  return {{"version", 1},
          {"unit", "m"},
          {"frame", poses_given ? "world of the poses" : "first camera"},
          {"frames", frames},
          {"tracks", std::move(list)}};
}

bool writeMapMesh(const std::string& path, const std::vector<MappedTrack>& tracks) {
#ifdef EPCC_WITH_GEOS
  std::vector<SurfacePolygon> surfaces;
  std::vector<Rgb> colors;
  for (const MappedTrack& one : tracks) {
    if (one.track.end != TrackEnd::None) continue;
    surfaces.push_back(one.surface);
    if (colors.size() < static_cast<std::size_t>(one.track.label))
      colors.resize(static_cast<std::size_t>(one.track.label));
    colors[static_cast<std::size_t>(one.track.label) - 1] = labelColor(one.track.label);
  }
  const SurfaceMesh mesh = surfaceMesh(surfaces);
  if (mesh.status == Status::OutOfMemory) throw std::bad_alloc();
  writeMesh(path, mesh, colors);
  return true;
#else
  static_cast<void>(path);
  static_cast<void>(tracks);
  return false;
#endif
}

void writeLastingLabels(const std::string& path, int width, int height, const std::vector<std::int32_t>& labels) {
  LabelImage image(width, height);
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    if (labels[i] >= kIgnoreLabel) throw OutputError(path, "labels", "more than 65534 of them: take fewer frames");
    image.data[i] = static_cast<std::uint16_t>(std::max(0, labels[i]));
  }
  writeGray16(path, image);
}

long rewriteLabels(const std::vector<PlaneTrack>& tracks, const std::vector<std::string>& names,
                   const std::string& folder) {
  const std::map<int, int> now = finalLabels(tracks);
  std::set<long> frames;
  for (const PlaneTrack& track : tracks)
    if (now.at(track.label) != track.label)
      for (long frame = track.first_frame; frame <= track.last_frame; ++frame) frames.insert(frame);
  long rewritten = 0;
  for (const long frame : frames) {
    const std::string path =
        (std::filesystem::path(folder) / (names.at(static_cast<std::size_t>(frame)) + "_labels.png")).string();
    LabelImage image = readGray16(path);
    bool changed = false;
    for (std::uint16_t& label : image.data) {
      if (label == 0) continue;
      const auto found = now.find(label);
      if (found == now.end() || found->second == label) continue;
      label = static_cast<std::uint16_t>(found->second);
      changed = true;
    }
    if (changed) writeGray16(path, image);
    rewritten += changed ? 1 : 0;
  }
  return rewritten;
}

}  // namespace epcc
