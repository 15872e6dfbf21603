// SPDX-License-Identifier: BSD-3-Clause
// Names, checks and help texts of the options of epcc_noise.
#include "eval/noise/noise_options.h"

#include <CLI/CLI.hpp>
#include <ostream>

#include "datasets/support/folder_listing.h"
#include "epcc_segmentation/depth_frame.h"
#include "eval/program/command_line.h"
#include "eval/program/reading_arguments.h"

namespace epcc {
namespace {

constexpr const char* kDescription =
    "Measures the error of a depth sensor on frames of it, all pooled, and writes NAME.json and NAME.png. The JSON is\n"
    "a sensor model for --noise NAME.json of the other programs.\n"
    "INPUT is an organized .pcd, a 16-bit depth .png, or a data set: FOLDER or FORMAT:FOLDER, with one of the formats\n"
    "that epcc_eval reads. All must be of one camera.";

constexpr const char* kFooter =
    "Exit codes: 0 done, 2 wrong usage, 3 an input could not be used or nothing could be measured (the rest is done),\n"
    "4 an output could not be written.";

struct RawOptions {
  std::optional<double> fx, fy, cx, cy, depth_scale;
  ReadingArguments reading;
};

std::string setCamera(const RawOptions& raw, SegmentOptions& input) {
  const int given = raw.fx.has_value() + raw.fy.has_value() + raw.cx.has_value() + raw.cy.has_value();
  if (given == 0) return raw.depth_scale ? "--depth-scale needs --fx --fy --cx --cy" : "";
  if (given < 4) return "--fx, --fy, --cx and --cy come together";
  if (!input.camera_file.empty()) return "--camera takes the place of --fx, give one of them";
  const CameraNumbers numbers{*raw.fx, *raw.fy, *raw.cx, *raw.cy, raw.depth_scale.value_or(0.001)};
  const std::string problem = numbers.validate();
  if (!problem.empty()) return problem;
  if (raw.depth_scale && input.reading.unit) return "--unit takes the place of --depth-scale, give one of them";
  input.camera = numbers;
  return {};
}

std::string checkOut(const std::string& text) {
  for (const char* ending : {".json", ".png"})
    if (hasEnding(text, ending)) return "'" + text + "' is to be the name without " + ending;
  return text.empty() || text.back() == '/' ? "'" + text + "' names no file" : std::string();
}

}  // namespace

std::optional<int> parseNoiseOptions(int argc, const char* const* argv, NoiseCommandOptions& options, std::ostream& out,
                                     std::ostream& err) {
  CLI::App app(kDescription, "epcc_noise");
  app.footer(kFooter);
  app.set_version_flag("--version", versionText("epcc_noise"));
  app.set_help_flag("-h,--help", "Print this help and exit");
  RawOptions raw;
  app.add_option("INPUT", options.input.inputs, "Frames of one camera")->required()->check(checkPath);
  app.add_option("--out", options.out, "Path of the outputs without .json and .png")
      ->required()
      ->type_name("NAME")
      ->check(checkOut);
  app.add_option("--camera", options.input.camera_file, "Camera of all depth images")
      ->type_name("FILE.json")
      ->check(checkPath);
  app.add_option("--fx", raw.fx, "Focal length, pixels");
  app.add_option("--fy", raw.fy, "Focal length, pixels");
  app.add_option("--cx", raw.cx, "Principal point, pixels");
  app.add_option("--cy", raw.cy, "Principal point, pixels");
  app.add_option("--depth-scale", raw.depth_scale, "Metres a depth unit (0.001)");
  addReadingArguments(app, raw.reading);
  return parseCommandLine(app, argc, argv, out, err, [&] {
    std::string problem;
    options.input.reading = readingOptions(raw.reading, problem);
    if (problem.empty()) problem = setCamera(raw, options.input);
    require(problem.empty(), problem);
  });
}

}  // namespace epcc
