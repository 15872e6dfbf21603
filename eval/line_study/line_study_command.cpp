// SPDX-License-Identifier: BSD-3-Clause
// Prints the tables of docs/research/laser_lines.md.
#include "eval/line_study/line_study_command.h"

#include <CLI/CLI.hpp>
#include <ostream>

#include "datasets/files/png_io.h"
#include "eval/line_study/line_study.h"
#include "eval/program/command_line.h"

namespace epcc {

int lineStudyMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  constexpr const char* kProgram = "epcc_line_study";
  CLI::App app("Compares methods for the lines of laser scans on rendered floor plans and prints tables.", kProgram);
  app.footer("Exit codes: 0 done, 2 wrong usage, 4 an output could not be written.");
  app.set_version_flag("--version", versionText(kProgram));
  app.set_help_flag("-h,--help", "Print this help and exit");
  LineStudyOptions options;
  app.add_option("--plans", options.plans, "Floor plans")->capture_default_str();
  app.add_option("--scans", options.scans, "Scans of each plan")->capture_default_str();
  app.add_option("--split-distance", options.split_distance, "Of Split-and-Merge, metres")->capture_default_str();
  app.add_option("--ransac-distance", options.ransac_distance, "Of RANSAC, metres")->capture_default_str();
  app.add_option("--k-max", options.parameters.k_max, "As in epcc_lines")->capture_default_str();
  app.add_option("--max-gap", options.parameters.max_gap, "As in epcc_lines")->capture_default_str();
  std::string map;
  app.add_option("--map", map, "Picture of the lines of the first plan")->type_name("FILE.png")->check(checkPath);
  const auto done = parseCommandLine(app, argc, argv, out, err, [&] {
    require(options.plans >= 1 && options.plans <= 1000, "--plans: must be 1 to 1000");
    require(options.scans >= 1 && options.scans <= 1000, "--scans: must be 1 to 1000");
    require(options.split_distance > 0.0 && options.ransac_distance > 0.0, "distances must be positive");
    const std::string problem = options.parameters.validate();
    require(problem.empty(), problem);
  });
  if (done) return *done;
  return runProgram(kProgram, out, err, [&] {
    if (!map.empty()) writeRgb(map, drawMap(floorMap(options)));
    out << lineStudyTables(runLineStudy(options));
    return kExitDone;
  });
}

}  // namespace epcc
