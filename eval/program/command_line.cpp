// SPDX-License-Identifier: BSD-3-Clause
// CLI11's exceptions and the project's, made into lines and exit codes.
#include "eval/program/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ostream>
#include <thread>

#include "datasets/support/input_error.h"

namespace epcc {

namespace {

constexpr std::size_t kLongestLine = 1000;

/// "epcc_eval merge" -> "epcc_eval: merge: "
std::string complaint(const std::string& program) {
  const std::size_t space = program.find(' ');
  if (space == std::string::npos) return program + ": ";
  return program.substr(0, space) + ": " + program.substr(space + 1) + ": ";
}

}  // namespace

std::optional<int> parseCommandLine(CLI::App& app, int argc, const char* const* argv, std::ostream& out,
                                    std::ostream& err, const std::function<void()>& settle) {
  try {
    app.parse(argc, argv);
    if (settle) settle();
  } catch (const CLI::CallForHelp&) {
    out << app.help();
    return kExitDone;
  } catch (const CLI::CallForVersion& version) {
    out << version.what() << '\n';
    return kExitDone;
  } catch (const CLI::ParseError& error) {
    err << complaint(app.get_name()) << printable(error.what(), kLongestLine) << " (see " << app.get_name()
        << " --help)\n";
    return kExitUsage;
  }
  return std::nullopt;
}

void require(bool condition, const std::string& problem) {
  if (!condition) throw CLI::ValidationError(problem);
}

int runProgram(const std::string& program, std::ostream& out, std::ostream& err, const std::function<int()>& run) {
  const auto complain = [&](const std::string& problem, ExitCode code) {
    err << complaint(program) << problem << '\n';
    return static_cast<int>(code);
  };
  try {
    const int code = run();
    out.flush();
    return out ? code : complain("standard output: cannot be written", kExitOutput);
  } catch (const OutputError& error) {
    return complain(error.what(), kExitOutput);
  } catch (const InputError& error) {
    return complain(error.what(), kExitInput);
  } catch (const std::exception& error) {
    return complain(printable(error.what(), kLongestLine), kExitInput);
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
