// SPDX-License-Identifier: BSD-3-Clause
// What a program throws becomes one line and an exit code.
#include "eval/program/command_line.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <new>
#include <sstream>
#include <stdexcept>

#include "datasets/support/input_error.h"

namespace epcc {
namespace {

/// Exit code and line of a step that throws.
template <typename Error>
std::pair<int, std::string> outcome(const Error& error, const std::string& program = "epcc_test") {
  std::ostringstream err;
  const int code = runStep(program, err, [&]() -> int { throw error; });
  return {code, err.str()};
}

using Outcome = std::pair<int, std::string>;

TEST(RunStep, ErrorsBecomeALineAndAnExitCode) {
  EXPECT_EQ(outcome(InputError("a.png", "size", "is odd")), Outcome(3, "epcc_test: a.png: size: is odd\n"));
  EXPECT_EQ(outcome(OutputError("a.png", "file", "disk full")), Outcome(4, "epcc_test: a.png: file: disk full\n"));
  EXPECT_EQ(outcome(std::bad_alloc()), Outcome(3, "epcc_test: needs more memory than there is\n"));
  EXPECT_EQ(outcome(std::runtime_error("two\nlines")), Outcome(3, "epcc_test: two?lines\n"));
  EXPECT_EQ(outcome(std::runtime_error("x"), "epcc_eval merge"), Outcome(3, "epcc_eval: merge: x\n"));
}

/// Exit code and line of a program with an INPUT and --size, the latter of which a file may be to blame for.
Outcome outcomeOf(std::vector<const char*> arguments) {
  CLI::App app("", "epcc_test");
  std::string input, size;
  app.add_option("INPUT", input)->required()->check(checkPath);
  app.add_option("--size", size)->check([](const std::string& text) -> std::string {
    throw InputError(text, "size", "is odd");
  });
  arguments.insert(arguments.begin(), "epcc_test");
  std::ostringstream out, err;
  const auto code = parseCommandLine(app, static_cast<int>(arguments.size()), arguments.data(), out, err);
  return {code.value_or(-1), err.str()};
}

TEST(ParseCommandLine, TellsOfATypoBeforeWhatIsMissingForIt) {
  EXPECT_EQ(outcomeOf({}), Outcome(2, "epcc_test: INPUT is required (see epcc_test --help)\n"));
  EXPECT_EQ(outcomeOf({"--sise"}),
            Outcome(2, "epcc_test: The following argument was not expected: --sise (see epcc_test --help)\n"));
  EXPECT_EQ(outcomeOf({""}), Outcome(2, "epcc_test: INPUT: the name is empty (see epcc_test --help)\n"));
}

TEST(ParseCommandLine, AFileThatAnOptionNamesIsAnInput) {
  EXPECT_EQ(outcomeOf({"a.png", "--size", "b.json"}), Outcome(3, "epcc_test: b.json: size: is odd\n"));
}

TEST(ParseCommandLine, HelpThatCannotBeWrittenIsAnError) {
  for (const char* option : {"--help", "--version"}) {
    CLI::App app("", "epcc_test");
    app.set_version_flag("--version", "epcc_test 1");
    const char* arguments[] = {"epcc_test", option};
    std::ostringstream out, err;
    out.setstate(std::ios::badbit);
    EXPECT_EQ(parseCommandLine(app, 2, arguments, out, err), kExitOutput);
    EXPECT_EQ(err.str(), "epcc_test: standard output: cannot be written\n");
  }
}

TEST(RunStep, CodesArePassedOn) {
  std::ostringstream err;
  EXPECT_EQ(runStep("epcc_test", err, [] { return 2; }), 2);
  EXPECT_EQ(err.str(), "");
}

TEST(RunProgram, OutputThatCannotBeWrittenIsAnError) {
  std::ostringstream out, err;
  EXPECT_EQ(runProgram("epcc_test", out, err, [] { return kExitDone; }), kExitDone);
  out.setstate(std::ios::badbit);
  EXPECT_EQ(runProgram("epcc_test", out, err, [] { return kExitDone; }), kExitOutput);
  EXPECT_EQ(err.str(), "epcc_test: standard output: cannot be written\n");
}

}  // namespace
}  // namespace epcc
