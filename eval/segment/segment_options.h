// SPDX-License-Identifier: BSD-3-Clause
// The command line of epcc_segment.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "datasets/sources/reading_options.h"
#include "epcc_segmentation/parameters.h"

namespace epcc {

/// Intrinsics named on the command line; the size comes from the image.
struct CameraNumbers {
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
  double depth_scale = 0.001;  ///< metres per depth unit
  /// Empty, or what is wrong with them.
  std::string validate() const;
};

/// Said of options that name an output file.
constexpr const char* kOneInputOnly =
    "--labels, --planes, --overlay, --cloud, --segments, --segments-picture, --mesh and --polygons take a single "
    "input; "
    "use --out DIR for several";

/// What epcc_segment is asked to do.
struct SegmentOptions {
  std::vector<std::string> inputs;
  std::string camera_file;
  std::optional<CameraNumbers> camera;
  ReadingOptions reading;
  std::string noise;  ///< sensor model as on the command line; empty: the frame's own, else auto
  Parameters parameters;
  std::string labels;
  std::string planes;
  std::string overlay;
  std::string cloud;
  std::string segments;
  std::string segments_picture;
  std::string mesh;
  std::string polygons;
  bool mesh_is_text = false;   ///< PLY
  std::string out;             ///< folder; empty: the files above
  bool with_segments = false;  ///< of the two files of line segments in the folder
  bool with_surfaces = false;  ///< mesh and polygons in the folder
  bool timing = false;

  bool givesCamera() const { return camera.has_value() || !camera_file.empty(); }
  bool namesOutputs() const {
    return !(labels.empty() && planes.empty() && overlay.empty() && cloud.empty() && segments.empty() &&
             segments_picture.empty() && mesh.empty() && polygons.empty());
  }
};

/// Reads the command line. Returns an exit code if the program is done (help, version, or an error that has been
/// reported on `err` in one line), nothing if `options` is to be carried out.
std::optional<int> parseSegmentOptions(int argc, const char* const* argv, SegmentOptions& options, std::ostream& out,
                                       std::ostream& err);

}  // namespace epcc
