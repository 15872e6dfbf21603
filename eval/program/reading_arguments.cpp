// SPDX-License-Identifier: BSD-3-Clause
// Names, checks and help texts; numbers are kept as the shortest text that reads back.
#include "eval/program/reading_arguments.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <sstream>

#include "datasets/support/folder_listing.h"
#include "datasets/support/number_text.h"

namespace epcc {
namespace {

std::string checkNumber(const std::string& text) {
  const std::optional<double> value = numberFrom(text);
  return value && std::isfinite(*value) ? std::string() : "'" + text + "' is not a finite number";
}

std::string checkDepth(const std::string& text) {
  const std::string problem = checkNumber(text);
  if (!problem.empty()) return problem;
  return *numberFrom(text) > 0.0 ? std::string() : "'" + text + "' is not positive";
}

std::string checkUnit(const std::string& text) {
  const bool known = text == "m" || text == "cm" || text == "mm";
  return known ? std::string() : "'" + text + "' is none of 'm', 'cm', 'mm'";
}

std::string checkProjection(const std::string& text) {
  const bool known = text == "auto" || text == "camera" || text == "scanner";
  return known ? std::string() : "'" + text + "' is none of 'auto', 'camera', 'scanner'";
}

}  // namespace

void addReadingArguments(CLI::App& app, ReadingArguments& arguments) {
  app.add_option("--projection", arguments.projection,
                 "What took the clouds: auto | camera | scanner, in any frame (auto)")
      ->type_name("KIND")
      ->check(checkProjection)
      ->group("Input");
  addDepthArguments(app, arguments);
}

void addDepthArguments(CLI::App& app, ReadingArguments& arguments) {
  const auto add = [&](const char* name, auto& value, const char* type, const char* text, auto check) {
    return app.add_option(name, value, text)->type_name(type)->check(check)->group("Input");
  };
  add("--unit", arguments.unit, "m|cm|mm",
      "Unit of the numbers of clouds (m, or mm if that cannot be) and depth images", checkUnit);
  add("--min-depth", arguments.options.min_depth, "D", "Nearer points are invalid; depth or range, metres", checkDepth);
  add("--max-depth", arguments.options.max_depth, "D", "Farther points are invalid; depth or range, metres",
      checkDepth);
  add("--invalid", arguments.options.invalid, "VALUE",
      "Invalid, too: depths of this value, points that have it in x, y and z", checkNumber);
  app.add_flag("--distance", arguments.options.is_distance,
               "Depth images hold the length of the ray instead of the depth")
      ->group("Input");
}

ReadingOptions readingOptions(const ReadingArguments& arguments, std::string& problem) {
  ReadingOptions options = arguments.options;
  if (!(options.min_depth < options.max_depth)) problem = "--min-depth is not less than --max-depth";
  if (arguments.projection != "auto")
    options.sensor = arguments.projection == "camera" ? CloudOptions::Sensor::Camera : CloudOptions::Sensor::Scanner;
  if (!arguments.unit.empty()) options.unit = arguments.unit == "m" ? 1.0 : arguments.unit == "cm" ? 0.01 : 0.001;
  return options;
}

void FrameKinds::add(const std::string& file) {
  (hasEnding(file, ".pcd") ? has_clouds : has_depth_images) = true;
}

void FrameKinds::add(const FrameSource& source) {
  for (std::size_t i = 0; i < source.size() && !(has_clouds && has_depth_images); ++i) {
    const std::vector<std::string> files = source.files(i);
    add(files.empty() ? std::string() : files.front());
  }
}

std::string uselessOption(const ReadingOptions& options, const FrameKinds& kinds) {
  if (options.is_distance && kinds.has_clouds && !kinds.has_depth_images)
    return "--distance is for depth images, and there are clouds only";
  if (options.sensor != CloudOptions::Sensor::Any && kinds.has_depth_images && !kinds.has_clouds)
    return "--projection is for clouds, and there are depth images only";
  return {};
}

std::string readingText(const ReadingOptions& options) {
  std::ostringstream text;
  text.precision(17);
  if (options.sensor != CloudOptions::Sensor::Any)
    text << " --projection " << (options.sensor == CloudOptions::Sensor::Camera ? "camera" : "scanner");
  if (options.unit) text << " --unit " << (*options.unit == 1.0 ? "m" : *options.unit == 0.01 ? "cm" : "mm");
  if (options.min_depth > 0.0) text << " --min-depth " << options.min_depth;
  if (std::isfinite(options.max_depth)) text << " --max-depth " << options.max_depth;
  if (options.invalid) text << " --invalid " << *options.invalid;
  if (options.is_distance) text << " --distance";
  const std::string all = text.str();
  return all.empty() ? all : all.substr(1);
}

}  // namespace epcc
