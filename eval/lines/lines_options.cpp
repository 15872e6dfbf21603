// SPDX-License-Identifier: BSD-3-Clause
// Names, checks and help texts of the options of epcc_lines.
#include "eval/lines/lines_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <ostream>

#include "datasets/files/text_lines.h"
#include "datasets/support/number_text.h"
#include "eval/program/command_line.h"

namespace epcc {
namespace {

constexpr const char* kDescription =
    "Finds the line segments in scans of a laser range finder, with their uncertainty, and writes for each log\n"
    "NAME_lines.csv, a scan as NAME_scan.png and .svg and, if the log has poses, all lines as NAME_map.png and .svg.\n"
    "LOG is a CARMEN log (ROBOTLASER1, FLASER or RAWLASER1 messages) or a CSV table of scans with the columns of\n"
    "sensor_msgs/LaserScan; either may be packed by gzip.";

constexpr const char* kFooter =
    "Exit codes: 0 done, 2 wrong usage, 3 a log or a line of it could not be used (the rest is done), 4 an output\n"
    "could not be written.";

/// Empty if `text` is auto or A,B, else what is wrong.
std::string setNoise(const std::string& text, LinesOptions& options) {
  if (text == "auto") return {};
  const std::vector<std::string_view> fields = fieldsOf(text);
  if (fields.size() != 2) return "--noise: must be auto or A,B";
  const auto a = numberFrom(fields[0]), b = numberFrom(fields[1]);
  if (!a || !b) return "--noise: must be auto or A,B";
  if (!(*a >= 0.0 && *b >= 0.0 && std::isfinite(*a + *b))) return "--noise: A and B must not be negative";
  if (*a + *b == 0.0) return "--noise: A and B must not both be zero";
  options.noise = SensorModel::polynomial(0.0, *b, *a);
  const std::string problem = options.noise->validate();
  return problem.empty() ? problem : "--noise: " + problem;
}

/// What is wrong with a parameter, by the name of its option: "k_max: ..." as "--k-max: ...".
std::string asTyped(std::string problem) {
  if (problem.empty()) return problem;
  const auto end_of_name = std::find(problem.begin(), problem.end(), ':');
  std::replace(problem.begin(), end_of_name, '_', '-');
  return "--" + problem;
}

}  // namespace

std::optional<int> parseLinesOptions(int argc, const char* const* argv, LinesOptions& options, std::ostream& out,
                                     std::ostream& err) {
  CLI::App app(kDescription, "epcc_lines");
  app.footer(kFooter);
  app.set_version_flag("--version", versionText("epcc_lines"));
  app.set_help_flag("-h,--help", "Print this help and exit");
  std::string noise = "auto";
  LaserLineParameters& p = options.parameters;
  app.add_option("LOG", options.logs, "Logs of scans")->required()->check(checkPath);
  app.add_option("--out", options.out, "Folder of the outputs")->required()->type_name("DIR");
  app.add_option("--noise", noise, "sigma_r = A + B r in metres, or auto: measured on the log (auto)")
      ->type_name("A,B|auto");
  app.add_option("--k-max", p.k_max, "Largest error of a point of a line, sqrt(own variance + sigma_r^2)")
      ->capture_default_str();
  app.add_option("--min-points", p.min_points, "Fewest points of a line")->capture_default_str();
  app.add_option("--max-gap", p.max_gap, "Longest opening in a line, metres")->capture_default_str();
  app.add_option("--max-hidden", p.max_hidden, "Longest hidden part of a line, metres; 0 joins nothing")
      ->capture_default_str();
  app.add_option("--max-range", options.max_range, "From here on a range is no return, metres (as the log says)");
  app.add_option("--scan", options.scan, "Scan to draw, from 0 (the one with the most returns)")->type_name("N");
  app.add_option("--jobs", options.jobs, "Threads, 0 is one a core")->capture_default_str();
  app.add_flag("--timing", options.timing, "Print the time of a scan");
  return parseCommandLine(app, argc, argv, out, err, [&] {
    require(!options.out.empty(), "--out: the name is empty");
    std::string problem = setNoise(noise, options);
    if (problem.empty() && p.max_hidden == 0.0) p.join_hidden = false;
    if (problem.empty()) problem = asTyped(p.validate());
    require(problem.empty(), problem);
    require(!options.max_range || *options.max_range > 0.0, "--max-range: must be positive");
    require(!options.scan || *options.scan >= 0, "--scan: must not be negative");
    require(options.jobs >= 0 && options.jobs <= 256, "--jobs: must be 0 to 256");
  });
}

}  // namespace epcc
