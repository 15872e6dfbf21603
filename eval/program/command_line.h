// SPDX-License-Identifier: BSD-3-Clause
// What the command lines of all programs have in common.
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace epcc {

/// Exit codes of the programs.
enum ExitCode {
  kExitDone = 0,
  kExitUsage = 2,   ///< the command line cannot be understood
  kExitInput = 3,   ///< an input could not be used
  kExitOutput = 4,  ///< an output could not be written
};

/// Reads the command line of the program that `app` is named after ("epcc_eval merge" complains as "epcc_eval: merge"),
/// then calls `check`. Returns an exit code if the program is done: help, version, or an error, which is told on `err`
/// in one line: kExitUsage, or kExitInput for an InputError of a file that an option names. EPCC_VECTOR_UNIT counts as
/// part of it: no input is to blame for a unit that the machine has not.
std::optional<int> parseCommandLine(CLI::App& app, int argc, const char* const* argv, std::ostream& out,
                                    std::ostream& err, const std::function<void()>& check = {});

/// For `check`: ends it with a problem unless `condition` holds.
void require(bool condition, const std::string& problem);

/// A check of options that name a file or folder: what is wrong with the name, whatever is there.
std::string checkPath(const std::string& text);

/// Tells `err` what is wrong, in one line that starts with the program's name, and returns the code.
int reportProblem(const std::string& program, std::ostream& err, const std::string& problem, ExitCode code);

/// Runs a part of a program and returns its exit code. What it throws is told on `err` in one line.
int runStep(const std::string& program, std::ostream& err, const std::function<int()>& step);

/// Runs the program and returns its exit code. What it throws is told on `err` in one line, as is an `out` that cannot
/// be written.
int runProgram(const std::string& program, std::ostream& out, std::ostream& err, const std::function<int()>& run);

/// main() of a program named `program`: `run` with the standard streams. Memory that runs out where nothing else turns
/// it into a line and a code, before there is a command line for instance, is kExitInput like any that does.
int runMain(const char* program, int (*run)(int, const char* const*, std::ostream&, std::ostream&), int argc,
            const char* const* argv);

/// "0.1.0", and the line that --version prints: "epcc_segment 0.1.0".
std::string projectVersion();
std::string versionText(const std::string& program);

/// --jobs as typed; 0 is one a core.
int threadsFor(int jobs);

}  // namespace epcc
