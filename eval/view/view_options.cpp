// SPDX-License-Identifier: BSD-3-Clause
// Names, checks and help texts of the options of epcc_view.
#include "eval/view/view_options.h"

#include <CLI/CLI.hpp>
#include <ostream>
#include <sstream>

#include "eval/program/command_line.h"
#include "eval/program/frame_sensor.h"
#include "eval/segment/frame_arguments.h"
#include "eval/segment/frame_surfaces.h"
#include "eval/view/view_keys.h"

namespace epcc {
namespace {

constexpr const char* kDescription =
    "Shows organized point clouds and depth images with their planes in a window, where keys step through the inputs\n"
    "and change sensor and parameters; h lists them.\n"
    "INPUT is an organized .pcd, a 16-bit depth .png, or a data set: FOLDER or FORMAT:FOLDER, with one of the formats\n"
    "that epcc_eval reads. The camera of X_depth.png is read from X.json beside it unless given.";

constexpr const char* kFooter =
    "Where there is no screen: xvfb-run -a epcc_view INPUT --snapshot OUT.png\n"
    "Exit codes: 0 done, 2 wrong usage, 3 an input could not be used or there is no display, 4 an output could not be\n"
    "written.";

constexpr int kSmallestSide = 160, kLargestSide = 8192;  // pixels a side

/// "1280x800".
std::string setSize(const std::string& text, ViewOptions& options) {
  int width = 0, height = 0;
  char rest = 0;
  const bool is_size = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
  if (!is_size || std::min(width, height) < kSmallestSide || std::max(width, height) > kLargestSide)
    return "--size: '" + text + "' is not WIDTHxHEIGHT with sides from 160 to 8192 pixels";
  options.width = width;
  options.height = height;
  return {};
}

/// "points,polygons,normals": these and nothing else.
std::string setDrawn(const std::string& text, ViewOptions& options) {
  ViewStyle& style = options.style;
  bool polygons = false, contours = false;
  style.points = style.mesh = style.normals = false;
  std::istringstream stream(text + ',');
  for (std::string word; std::getline(stream, word, ',');) {
    bool* const drawn = word == "points"     ? &style.points
                        : word == "mesh"     ? &style.mesh
                        : word == "polygons" ? &polygons
                        : word == "contours" ? &contours
                        : word == "normals"  ? &style.normals
                                             : nullptr;
    if (drawn == nullptr) return "--draw: '" + word + "' is none of points, mesh, polygons, contours, normals";
    *drawn = true;
  }
  if (polygons && contours) return "--draw: outlines are polygons or contours; give one of them";
  if ((polygons || style.mesh) && !surfacesMissing().empty()) return "--draw: " + surfacesMissing();
  style.outlines = polygons || contours;
  if (style.outlines) style.outline_kind = polygons ? OutlineKind::Polygons : OutlineKind::Contours;
  return {};
}

std::string setKeys(const std::string& text, ViewOptions& options) {
  std::string unknown;
  const auto keys = keysFrom(text, unknown);
  if (!keys) return "--keys: '" + unknown + "' is no key of the window";
  options.keys = *keys;
  return {};
}

}  // namespace

std::optional<int> parseViewOptions(int argc, const char* const* argv, ViewOptions& options, std::ostream& out,
                                    std::ostream& err) {
  CLI::App app(kDescription, "epcc_view");
  app.footer(presetLine("PRESET") + kFooter);
  app.set_version_flag("--version", versionText("epcc_view"));
  FrameArguments arguments;
  std::string size = "1280x800", drawn, keys;
  addFrameArguments(app, "Files and folders to show", options.input, arguments);
  app.add_option("--snapshot", options.snapshot, "Write a picture of the window, without opening it, and exit")
      ->type_name("OUT.png")
      ->check(checkPath)
      ->group("Window");
  CLI::Option* const draw = app.add_option("--draw", drawn,
                                           "What is drawn at the start (points,mesh,polygons,contours,normals), else "
                                           "points, polygons and normals")
                                ->type_name("A,B,...")
                                ->group("Window");
  app.add_option("--keys", keys, "Keys that are pressed at the start: n,n,s,plus")
      ->type_name("KEY,...")
      ->group("Window");
  app.add_option("--size", size, "Of the window, pixels (1280x800)")->type_name("WxH")->group("Window");
  return parseCommandLine(app, argc, argv, out, err, [&] {
    std::string problem = setFrameOptions(arguments, options.input);
    if (problem.empty()) problem = setSize(size, options);
    if (problem.empty() && draw->count() > 0) problem = setDrawn(drawn, options);
    if (problem.empty()) problem = setKeys(keys, options);
    require(problem.empty(), problem);
  });
}

}  // namespace epcc
