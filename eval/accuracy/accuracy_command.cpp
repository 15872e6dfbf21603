// SPDX-License-Identifier: BSD-3-Clause
// Reads the command line, runs the accuracy experiments, prints the tables and renews them in the page.
#include "eval/accuracy/accuracy_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <ostream>

#include "datasets/files/png_io.h"
#include "datasets/support/atomic_file.h"
#include "datasets/support/input_error.h"
#include "datasets/support/output_folder.h"
#include "eval/accuracy/accuracy.h"
#include "eval/accuracy/accuracy_chart.h"
#include "eval/accuracy/accuracy_report.h"
#include "eval/program/command_line.h"
#include "eval/program/progress_line.h"

namespace epcc {

namespace {

constexpr const char* kDescription =
    "Scores the segmenter and the baselines on the public data sets, their halves and copies, a sequence, and "
    "rendered\n"
    "scenes.\n"
    "Prints the tables of docs/research/accuracy.md; with --page it renews them in that page, unless something was\n"
    "missing.";
constexpr const char* kFooter =
    "Exit codes: 0 done (frames that a method of PCL failed on are named), 2 wrong usage, 3 a data set is missing or "
    "a\n"
    "frame could not be scored (the rest is done, the page stays as it is), 4 an output could not be written.";

struct CommandOptions {
  AccuracyOptions accuracy{"../shared/data", "results/accuracy"};
  std::string page;
};

std::optional<int> parse(int argc, const char* const* argv, CommandOptions& options, std::ostream& out,
                         std::ostream& err) {
  CLI::App app(kDescription, "epcc_accuracy");
  app.footer(kFooter);
  app.set_version_flag("--version", versionText("epcc_accuracy"));
  AccuracyOptions& accuracy = options.accuracy;
  app.add_option("--data", accuracy.data, "Folder of the data sets (" + accuracy.data + ")")
      ->type_name("DIR")
      ->check(checkPath);
  app.add_option("--out", accuracy.out, "Folder for frames.csv, curve.png and overlays/ (" + accuracy.out + ")")
      ->type_name("DIR")
      ->check(checkPath);
  app.add_option("--page", options.page, "Page whose tables are renewed (none)")
      ->type_name("FILE.md")
      ->check(checkPath);
  app.add_option("--seeds", accuracy.seeds, "Seeds of each rendered scene and noise (2)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  app.add_option("--jobs", accuracy.jobs, "Frames at a time, 0 = one a core (1; more disturb the times)")
      ->type_name("J")
      ->check(CLI::Range(0, 1024));
  return parseCommandLine(app, argc, argv, out, err, [&] { accuracy.jobs = threadsFor(accuracy.jobs); });
}

std::string readPage(const std::string& path) {
  inputFileSize(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path, "file", "cannot be read");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

AccuracyResult measure(const AccuracyOptions& options, std::ostream& err) {
  ProgressLine progress(err);
  return runAccuracy(options, [&](std::size_t done, std::size_t total) { progress.show(done, total); });
}

/// The page is read before the work and written after it: a page that cannot be used costs no waiting.
int runAccuracyCommand(const CommandOptions& options, std::ostream& out, std::ostream& err) {
  std::string page;
  if (!options.page.empty()) {
    page = readPage(options.page);
    pageWithTables(page, accuracyTables({}), options.page);
  }
  makeOutputFolder(options.accuracy.out, {"frames.csv", "curve.png"});
  const AccuracyResult result = measure(options.accuracy, err);
  const std::vector<NamedTable> tables = accuracyTables(result);
  writeTextFile((std::filesystem::path(options.accuracy.out) / "frames.csv").string(), csvTable(result.rows));
  writeRgb((std::filesystem::path(options.accuracy.out) / "curve.png").string(), drawPlot(accuracyChart(result.curve)));
  for (const auto& [name, table] : tables) out << name << '\n' << textTable(table) << '\n';
  for (const std::string& failure : result.failures) err << "epcc_accuracy: " << printable(failure, 2000) << '\n';
  for (const std::string& problem : result.problems) err << "epcc_accuracy: " << printable(problem, 2000) << '\n';
  if (!result.problems.empty()) return kExitInput;
  if (!options.page.empty()) writeTextFile(options.page, pageWithTables(page, tables, options.page));
  return kExitDone;
}

}  // namespace

int accuracyMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  CommandOptions options;
  if (const auto done = parse(argc, argv, options, out, err)) return *done;
  return runProgram("epcc_accuracy", out, err, [&] { return runAccuracyCommand(options, out, err); });
}

}  // namespace epcc
