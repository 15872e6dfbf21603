// SPDX-License-Identifier: BSD-3-Clause
// Exceptions, CLI11's and the project's, become lines on standard error and exit codes.
#include "eval/program/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>
#include <ostream>
#include <thread>

#include "datasets/support/input_error.h"
#include "epcc_segmentation/vector_unit.h"
#include "eval/program/memory_reserve.h"

namespace epcc {

namespace {

constexpr std::size_t kMaxLineBytes = 2000;
constexpr const char* kNoMemory = "needs more memory than there is";

/// "epcc_eval merge" -> "epcc_eval: merge: "
std::string lineStart(const std::string& program) {
  const std::size_t space = program.find(' ');
  if (space == std::string::npos) return program + ": ";
  return program.substr(0, space) + ": " + program.substr(space + 1) + ": ";
}

/// An option with a typo counts as missing: the typo is the better thing to tell of.
void parseTold(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::RequiredError&) {
    const std::vector<std::string> unknown = app.remaining(true);
    if (!unknown.empty()) throw CLI::ExtrasError(unknown);
    throw;
  }
}

/// The code, or another if what was said could not be written.
int writtenCode(const std::string& program, std::ostream& out, std::ostream& err, int code) {
  out.flush();
  return out ? code : reportProblem(program, err, "standard output: cannot be written", kExitOutput);
}

}  // namespace

std::optional<int> parseCommandLine(CLI::App& app, int argc, const char* const* argv, std::ostream& out,
                                    std::ostream& err, const std::function<void()>& check) {
  try {
    parseTold(app, argc, argv);
    require(vectorUnitProblem().empty(), vectorUnitProblem());
    if (check) check();
  } catch (const CLI::CallForHelp&) {
    out << app.help();
    return writtenCode(app.get_name(), out, err, kExitDone);
  } catch (const CLI::CallForVersion& version) {
    out << version.what() << '\n';
    return writtenCode(app.get_name(), out, err, kExitDone);
  } catch (const CLI::ParseError& error) {
    err << lineStart(app.get_name()) << printable(error.what(), kMaxLineBytes) << " (see " << app.get_name()
        << " --help)\n";
    return kExitUsage;
  } catch (const InputError& error) {
    return reportProblem(app.get_name(), err, error.what(), kExitInput);
  }
  return std::nullopt;
}

void require(bool condition, const std::string& problem) {
  if (!condition) throw CLI::ValidationError(problem);
}

std::string checkPath(const std::string& text) {
  return text.empty() ? "the name is empty" : std::string();
}

int reportProblem(const std::string& program, std::ostream& err, const std::string& problem, ExitCode code) {
  err << lineStart(program) << printable(problem, kMaxLineBytes) << '\n';
  return code;
}

int runStep(const std::string& program, std::ostream& err, const std::function<int()>& step) {
  reserveMemory();
  try {
    return step();
  } catch (const OutputError& error) {
    return reportProblem(program, err, error.what(), kExitOutput);
  } catch (const std::bad_alloc&) {
    return reportProblem(program, err, kNoMemory, kExitInput);
  } catch (const std::exception& error) {
    return reportProblem(program, err, error.what(), kExitInput);
  }
}

int runProgram(const std::string& program, std::ostream& out, std::ostream& err, const std::function<int()>& run) {
  return writtenCode(program, out, err, runStep(program, err, run));
}

int runMain(const char* program, int (*run)(int, const char* const*, std::ostream&, std::ostream&), int argc,
            const char* const* argv) {
  reserveMemory();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that gets too large is an error like a full disk
  try {
    return run(argc, argv, std::cout, std::cerr);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: %s\n", program, kNoMemory);  // takes none
    return kExitInput;
  }
}

std::string projectVersion() {
  return EPCC_VERSION;
}

std::string versionText(const std::string& program) {
  return program + " " + projectVersion();
}

int threadsFor(int jobs) {
  return jobs > 0 ? jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace epcc
