// SPDX-License-Identifier: BSD-3-Clause
// No output may take the place of an input, of its ground truth, of another output or of a device.
#include "eval/segment/segment_output.h"

#include <filesystem>
#include <limits>
#include <set>

#include "datasets/files/label_image.h"
#include "datasets/files/organized_pcd.h"
#include "datasets/files/plane_list.h"
#include "datasets/files/png_io.h"
#include "datasets/files/segment_list.h"
#include "datasets/support/atomic_file.h"
#include "datasets/support/file_place.h"
#include "eval/pictures/overlay.h"
#include "eval/pictures/segment_picture.h"
#include "eval/program/frame_sensor.h"
#include "eval/segment/surface_output.h"

namespace epcc {
namespace {

namespace fs = std::filesystem;

// Files that must survive: the input, its camera, and the ground truth beside a depth image.
std::set<fs::path> filesOf(const SegmentInput& input, bool in_folder) {
  std::set<fs::path> files{filePlace(input.path)};
  if (input.source)
    for (const std::string& file : input.source->files(input.index)) files.insert(filePlace(file));
  if (!input.camera_file.empty()) files.insert(filePlace(input.camera_file));
  // Labels that --out writes beside their depth image would be taken for its truth from then on.
  const fs::path truth = fs::path(input.path).parent_path() / (input.name + "_labels.png");
  std::error_code error;
  if (in_folder || fs::exists(truth, error)) files.insert(filePlace(truth.string()));
  return files;
}

std::vector<float> pointsOf(const LabelledFrame& input) {
  const DepthFrame frame = frameView(input);
  std::vector<float> xyz(3 * input.depth.data.size(), std::numeric_limits<float>::quiet_NaN());
  Eigen::Vector3d point;
  for (int row = 0; row < frame.height(); ++row) {
    for (int column = 0; column < frame.width(); ++column) {
      if (!frame.point(row, column, point)) continue;
      const std::size_t i = 3 * frame.index(row, column);
      for (int k = 0; k < 3; ++k) xyz[i + static_cast<std::size_t>(k)] = static_cast<float>(point(k));
    }
  }
  return xyz;
}

}  // namespace

std::vector<std::string> OutputPaths::all() const {
  std::vector<std::string> paths;
  for (const std::string* path : {&labels, &planes, &overlay, &cloud, &segments, &segments_picture, &mesh, &polygons}) {
    if (!path->empty()) paths.push_back(*path);
  }
  return paths;
}

OutputPaths outputPaths(const SegmentOptions& options, const SegmentInput& input) {
  if (options.out.empty())
    return {options.labels,   options.planes,           options.overlay, options.cloud,
            options.segments, options.segments_picture, options.mesh,    options.polygons};
  const auto in_folder = [&](const char* suffix) { return (fs::path(options.out) / (input.name + suffix)).string(); };
  OutputPaths paths{in_folder("_labels.png"),
                    in_folder("_planes.json"),
                    in_folder("_overlay.png"),
                    in_folder("_cloud.pcd"),
                    "",
                    "",
                    "",
                    ""};
  if (options.with_segments) {
    paths.segments = in_folder("_segments.csv");
    paths.segments_picture = in_folder("_segments.png");
  }
  if (options.with_surfaces) {
    paths.mesh = in_folder("_mesh.ply");
    paths.polygons = in_folder("_polygons.json");
  }
  return paths;
}

std::string checkOutputs(const SegmentOptions& options, const std::vector<SegmentInput>& inputs) {
  std::set<fs::path> protected_files;
  for (const SegmentInput& input : inputs)
    protected_files.merge(filesOf(input, !options.out.empty() && !input.problem));
  std::set<fs::path> written;
  for (const SegmentInput& input : inputs) {
    if (input.problem && !options.out.empty()) continue;
    const std::string held = options.out.empty() ? std::string() : frameHeld(options.out, input.name);
    if (!held.empty())
      return "--out: " + options.out + " has " + held + ": labels beside it would be taken for its ground truth";
    for (const std::string& path : outputPaths(options, input).all()) {
      if (isNoiseFile(options.noise) && filePlace(options.noise) == filePlace(path))
        return path + " would overwrite the file of --noise";
      if (protected_files.count(filePlace(path)) != 0) return path + " would overwrite an input or its ground truth";
      if (!written.insert(filePlace(path)).second) return path + " would be written twice";
    }
  }
  return std::string();
}

void refuseSpecialFiles(const OutputPaths& paths) {
  for (const std::string& path : paths.all()) checkOutputFile(path);
}

void writeOutputs(const OutputPaths& paths, const LabelledFrame& input, const PlaneSegmentation& result,
                  const SurfaceStyle& surfaces) {
  refuseSpecialFiles(paths);
  if (!paths.labels.empty()) writeLabelImage(paths.labels, result);
  const DepthFrame view = frameView(input);
  if (!paths.planes.empty()) writePlaneList(paths.planes, result, view.projection(), view.geometry());
  if (!paths.overlay.empty()) writeRgb(paths.overlay, drawOverlay(input.depth, result.labels));
  if (!paths.cloud.empty())
    writeLabelledPcd(paths.cloud, result.width, result.height, pointsOf(input),
                     {result.labels.begin(), result.labels.end()});
  if (!paths.segments.empty()) writeSegmentList(paths.segments, result.segments);
  if (!paths.segments_picture.empty()) writeRgb(paths.segments_picture, drawSegments(input.depth, result.segments));
#ifdef EPCC_WITH_GEOS
  writeSurfaces(paths, view, result, surfaces);
#else
  static_cast<void>(surfaces);
#endif
}

}  // namespace epcc
