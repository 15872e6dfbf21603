// SPDX-License-Identifier: BSD-3-Clause
// epcc_compare's command line: options, errors, files.
#include "eval/compare_command.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "eval/compare_options.h"

namespace epcc {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int code = -1;
  std::string out, err;
};

Outcome run(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "epcc_compare");
  std::vector<const char*> argv;
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  std::ostringstream out, err;
  Outcome outcome;
  outcome.code = compareMain(static_cast<int>(argv.size()), argv.data(), out, err);
  outcome.out = out.str();
  outcome.err = err.str();
  return outcome;
}

class CompareCommand : public testing::Test {
 protected:
  CompareCommand() {
    std::string pattern = (fs::temp_directory_path() / "epcc_compare_test_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) std::abort();
    folder_ = pattern;
  }
  ~CompareCommand() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  fs::path folder_;
};

TEST_F(CompareCommand, UsageErrorsAreOneLine) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--scenes", "e"}, "unknown scene 'e'"},
      {{"--scenes", "a,a"}, "named twice"},
      {{"--scenes", ""}, "at least one"},
      {{"--noise", "loud"}, "--noise"},
      {{"--noise", "white:nothing"}, "--noise"},
      {{"--seeds", "0"}, "--seeds"},
      {{"--paper", "--default"}, "--default"},
      {{"--nonsense"}, "--nonsense"},
      {{"study", "nothing"}, "unknown study 'nothing'"},
      {{"study"}, "NAME"},
      {{"study", "scan", "--default"}, "--default"}};
  for (const auto& [arguments, words] : cases) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.rfind("epcc_compare: ", 0), 0U) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  }
}

TEST_F(CompareCommand, HelpAndVersion) {
  EXPECT_EQ(run({"--help"}).code, 0);
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
  const Outcome outcome = run({"--scenes", "b", "--seeds", "1", "--out", path("results")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("surrogates"), std::string::npos);
  EXPECT_NE(outcome.out.find("epcc-paper"), std::string::npos);
  for (const char* name : {"table4.md", "table4.csv", "table4.json", "table4.tex", "figure21.png"})
    EXPECT_GT(fs::file_size(path("results") + "/" + name), 0U) << name;
}

TEST_F(CompareCommand, StudyLeavesTablesAndPicture) {
  const Outcome outcome = run({"study", "scan", "--scenes", "a", "--seeds", "1", "--out", path("studies")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("columns"), std::string::npos);
  for (const char* name : {"study_scan.md", "study_scan.csv", "study_scan.png"})
    EXPECT_GT(fs::file_size(path("studies") + "/" + name), 0U) << name;
}

TEST_F(CompareCommand, FolderThatCannotBeMadeIsAnOutputError) {
  const Outcome outcome = run({"study", "scan", "--scenes", "a", "--seeds", "1", "--out", "/dev/null/x"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(outcome.err.rfind("epcc_compare: ", 0), 0U) << outcome.err;
}

}  // namespace
}  // namespace epcc
