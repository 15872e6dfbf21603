// SPDX-License-Identifier: BSD-3-Clause
// Prints the table of docs/research/uncertainty.md and leaves its files and pictures.
#include "eval/consistency/consistency_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <ostream>

#include "datasets/files/png_io.h"
#include "datasets/support/atomic_file.h"
#include "datasets/support/output_folder.h"
#include "eval/consistency/consistency_report.h"
#include "eval/program/command_line.h"
#include "eval/program/progress_line.h"

namespace epcc {

namespace {

constexpr const char* kProgram = "epcc_consistency";
constexpr const char* kDescription =
    "Renders scenes whose planes are known, with errors of known size and correlation, and compares the errors of\n"
    "planes and line segments with the covariances that they are given.\n"
    "Prints a table: the normalised squared error of a plane has a mean of 3, of a line segment of 2, if they are "
    "right.";
constexpr const char* kFooter =
    "Leaves in --out: consistency.csv (the table), surfaces.csv (by surface), consistency.json (quantiles),\n"
    "planes.png, lines.png.\n"
    "Exit codes: 0 done, 2 wrong usage, 4 an output could not be written.";

std::vector<ConsistencyRow> measure(int runs, std::ostream& err) {
  ProgressLine progress(err);
  return runConsistency(runs, [&](std::size_t done, std::size_t total) { progress.show(done, total); });
}

void writeAll(const std::string& folder, const std::vector<ConsistencyRow>& rows) {
  const auto in = [&](const char* name) { return (std::filesystem::path(folder) / name).string(); };
  writeTextFile(in("consistency.csv"), csvTable(consistencyTable(rows)));
  writeTextFile(in("surfaces.csv"), csvTable(surfacesTable(rows)));
  writeTextFile(in("consistency.json"), consistencyJson(rows));
  writeRgb(in("planes.png"), drawPlot(consistencyChart(rows, 3)));
  writeRgb(in("lines.png"), drawPlot(consistencyChart(rows, 2)));
}

}  // namespace

int consistencyMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  CLI::App app(kDescription, kProgram);
  app.footer(kFooter);
  app.set_version_flag("--version", versionText(kProgram));
  app.set_help_flag("-h,--help", "Print this help and exit");
  int runs = 125;
  std::string folder;
  app.add_option("--runs", runs, "Renderings of each of four scenes with each error (125)")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  app.add_option("--out", folder, "Folder for files and pictures (none)")->type_name("DIR")->check(checkPath);
  if (const auto done = parseCommandLine(app, argc, argv, out, err, [] {})) return *done;
  return runProgram(kProgram, out, err, [&] {
    if (!folder.empty())
      makeOutputFolder(folder, {"consistency.csv", "surfaces.csv", "consistency.json", "planes.png", "lines.png"});
    const auto rows = measure(runs, err);
    if (!folder.empty()) writeAll(folder, rows);
    out << textTable(consistencyTable(rows));
    return kExitDone;
  });
}

}  // namespace epcc
