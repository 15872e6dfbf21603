// SPDX-License-Identifier: BSD-3-Clause
// Names, checks and help texts of the options of epcc_segment.
#include "eval/segment/segment_options.h"

#include <CLI/CLI.hpp>
#include <ostream>

#include "datasets/support/folder_listing.h"
#include "epcc_segmentation/depth_frame.h"
#include "eval/program/command_line.h"
#include "eval/program/frame_sensor.h"
#include "eval/segment/frame_arguments.h"
#include "eval/segment/frame_surfaces.h"
#include "eval/segment/parameter_page.h"

namespace epcc {
namespace {

constexpr const char* kDescription =
    "Segments organized point clouds and depth images into planes.\n"
    "INPUT is an organized .pcd, a 16-bit depth .png, or a data set: FOLDER or FORMAT:FOLDER, with one of the formats\n"
    "that epcc_eval reads. The camera of X_depth.png is read from X.json beside it unless given.";

constexpr const char* kFooter =
    "EPCC_VECTOR_UNIT=avx2, or another that the processor has, chooses its vector unit; the labels are the same.\n"
    "Exit codes: 0 done, 2 wrong usage, 3 an input could not be used, 4 an output could not be written.";

/// Polygons and meshes may be left out of a build.
std::string checkSurfaces(const std::string& /*text*/) {
  return surfacesMissing();
}

std::string checkMesh(const std::string& text) {
  if (!hasEnding(text, ".ply") && !hasEnding(text, ".obj")) return "'" + text + "' ends neither in .ply nor in .obj";
  return checkSurfaces(text);
}

void addOutputOptions(CLI::App& app, SegmentOptions& options) {
  const auto add = [&](const char* name, std::string& value, const char* type, const char* text) {
    return app.add_option(name, value, text)->type_name(type)->check(checkPath)->group("Output");
  };
  CLI::Option* out = add("--out", options.out, "DIR",
                         "Folder for NAME_labels.png, NAME_planes.json, NAME_overlay.png "
                         "and NAME_cloud.pcd of every input");
  add("--labels", options.labels, "OUT.png", "16-bit label image: 0 none, planes from 1")->excludes(out);
  add("--planes", options.planes, "OUT.json", "List of the planes")->excludes(out);
  add("--overlay", options.overlay, "OUT.png", "Picture of the labels on the depth")->excludes(out);
  add("--cloud", options.cloud, "OUT.pcd", "Labelled organized cloud")->excludes(out);
  add("--segments", options.segments, "OUT.csv", "List of the line segments of the scan lines")->excludes(out);
  add("--segments-picture", options.segments_picture, "OUT.png", "Picture of the line segments on the depth")
      ->excludes(out);
  app.add_flag("--with-segments", options.with_segments, "With --out: also NAME_segments.csv and NAME_segments.png")
      ->needs(out)
      ->group("Output");
  add("--mesh", options.mesh, "OUT.ply", "Triangle mesh of the surfaces, .ply or .obj")
      ->check(checkMesh)
      ->excludes(out);
  add("--polygons", options.polygons, "OUT.json", "Surfaces as polygons with holes, and their edges")
      ->check(checkSurfaces)
      ->excludes(out);
  app.add_flag("--mesh-text", options.mesh_is_text, "Mesh as text, not binary (.ply; .obj is text)")->group("Output");
  app.add_flag("--with-surfaces", options.with_surfaces, "With --out: also NAME_mesh.ply and NAME_polygons.json")
      ->needs(out)
      ->group("Output");
  app.add_flag("--timing", options.timing, "Print the time of each stage")->group("Output");
}

// Ends the reading of the command line with a text to print, as --version does.
void printParameters() {
  std::string page = parameterPage();
  page.pop_back();  // a new line follows
  throw CLI::CallForVersion(page, 0);
}

}  // namespace

std::string CameraNumbers::validate() const {
  if (!(depth_scale > 0.0 && depth_scale <= kMaxDepthScale)) return "--depth-scale: must be positive, at most 1000";
  const std::string problem = PinholeCamera{1, 1, fx, fy, cx, cy}.validate();
  return problem.empty() ? problem : "camera: " + problem;
}

std::optional<int> parseSegmentOptions(int argc, const char* const* argv, SegmentOptions& options, std::ostream& out,
                                       std::ostream& err) {
  CLI::App app(kDescription, "epcc_segment");
  app.footer(presetLine("PRESET") + kFooter);
  app.set_version_flag("--version", versionText("epcc_segment"));
  FrameArguments arguments;
  app.add_flag_callback("--list-parameters", printParameters,
                        "Print every parameter with default, range and effect, and exit");
  addFrameArguments(app, "Files and folders to segment", options, arguments);
  addOutputOptions(app, options);
  return parseCommandLine(app, argc, argv, out, err, [&] {
    std::string problem = setFrameOptions(arguments, options);
    if (problem.empty() && options.with_surfaces && !checkSurfaces("").empty())
      problem = "--with-surfaces: " + checkSurfaces("");
    require(problem.empty(), problem);
    require(!options.mesh_is_text || options.with_surfaces || !options.mesh.empty(),
            "--mesh-text requires --mesh or --with-surfaces");
    options.parameters.line_segments |=
        options.with_segments || !options.segments.empty() || !options.segments_picture.empty();
  });
}

}  // namespace epcc
