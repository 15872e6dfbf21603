// SPDX-License-Identifier: BSD-3-Clause
// epcc_compare's command line: options, errors, files.
#include "eval/comparison/compare_command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "eval/comparison/compare_options.h"
#include "tests/support/run_tool.h"

namespace epcc::test {
namespace {

namespace fs = std::filesystem;

ToolResult run(const std::vector<std::string>& arguments) {
  return callTool(compareMain, "epcc_compare", arguments);
}

class CompareCommand : public TempFolderTest {};

TEST_F(CompareCommand, UsageErrorsAreOneLine) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--scenes", "e"}, "unknown scene 'e'"},
      {{"--scenes", "a,a"}, "named twice"},
      {{"--scenes", ""}, "at least one"},
      {{"--noise", "loud"}, "--noise"},
      {{"--noise", "white:nothing"}, "--noise"},
      {{"--seeds", "0"}, "--seeds"},
      {{"--first-seed", "-1"}, "is not a whole number"},
      {{"--first-seed", "18446744073709551616"}, "is not a whole number"},
      {{"--first-seed", "18446744073709551615"}, "the last seed is larger"},
      {{"--paper", "--default"}, "--default"},
      {{"--nonsense"}, "--nonsense"},
      {{"study", "nothing"}, "unknown study 'nothing'"},
      {{"study"}, "NAME"},
      {{"--out", ""}, "--out: the name is empty"},
      {{"study", "scan", "--default"}, "--default"}};
  for (const auto& [arguments, words] : cases) expectFailure(run(arguments), "epcc_compare", 2, words);
}

TEST_F(CompareCommand, AFolderThatCannotBeMadeIsToldBeforeTheWork) {
  std::ofstream(path("file")) << "text";
  // So many seeds would take days.
  std::filesystem::create_directories(path("results/table4.csv"));
  expectFailure(run({"--seeds", "100000", "--out", path("results")}), "epcc_compare", 4,
                "table4.csv: file: is a folder");
  expectFailure(run({"--seeds", "100000", "--slow-seeds", "100000", "--out", path("file")}), "epcc_compare", 4,
                "file: folder");
}

TEST_F(CompareCommand, HelpAndVersion) {
  EXPECT_EQ(run({"--help"}).exit_code, 0);
  EXPECT_NE(run({"--help"}).out.find("--slow-seeds"), std::string::npos);
  EXPECT_EQ(run({"--version"}).out.rfind("epcc_compare ", 0), 0U);
}

TEST_F(CompareCommand, SlowSeedsFollowFewSeeds) {
  CompareOptions options;
  std::ostringstream out, err;
  const char* argv[] = {"epcc_compare", "--seeds", "3", "--default"};
  EXPECT_FALSE(parseCompareOptions(4, argv, options, out, err).has_value());
  EXPECT_EQ(options.comparison.slow_seeds, 3);
  EXPECT_EQ(options.comparison.parameters, ParameterSet::Default);
  EXPECT_EQ(options.comparison.noise.kind, NoiseKind::Stereo);
}

TEST_F(CompareCommand, LeavesTablesAndPicture) {
  const ToolResult outcome = run({"--scenes", "b", "--seeds", "1", "--out", path("results")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("surrogates"), std::string::npos);
  EXPECT_NE(outcome.out.find("epcc-paper"), std::string::npos);
  for (const char* name : {"table4.md", "table4.csv", "table4.json", "table4.tex", "figure21.png"})
    EXPECT_GT(fs::file_size(path("results") + "/" + name), 0U) << name;
}

TEST_F(CompareCommand, StudyLeavesTablesAndPicture) {
  const ToolResult outcome = run({"study", "scan", "--scenes", "a", "--seeds", "1", "--out", path("studies")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("columns"), std::string::npos);
  for (const char* name : {"study_scan.md", "study_scan.csv", "study_scan.png"})
    EXPECT_GT(fs::file_size(path("studies") + "/" + name), 0U) << name;
}

TEST_F(CompareCommand, FolderThatCannotBeMadeIsAnOutputError) {
  const ToolResult outcome = run({"study", "scan", "--scenes", "a", "--seeds", "1", "--out", "/dev/null/x"});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_EQ(outcome.err.rfind("epcc_compare: ", 0), 0U) << outcome.err;
}

}  // namespace
}  // namespace epcc::test
