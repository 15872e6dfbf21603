// SPDX-License-Identifier: BSD-3-Clause
// Temporary folders, generated frames, and starting the program.
#include "eval_runner.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include "tiny_frames.h"

namespace epcc::test {

namespace fs = std::filesystem;

namespace {

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

EvalToolTest::EvalToolTest() {
  std::string pattern = (fs::temp_directory_path() / "epcc_eval_test_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) std::abort();
  folder_ = pattern;
}

EvalToolTest::~EvalToolTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

EvalResult EvalToolTest::runShell(const std::string& before, const std::vector<std::string>& arguments) const {
  std::string command = "cd " + quoted(folder_.string()) + " && " + before + quoted(EPCC_EVAL);
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  command += " >stdout 2>stderr </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("stdout"), read("stderr")};
}

EvalResult EvalToolTest::run(const std::vector<std::string>& arguments) const {
  return runShell("", arguments);
}

EvalResult EvalToolTest::runAndKill(const std::vector<std::string>& arguments, int milliseconds) const {
  return runShell("timeout -s KILL " + std::to_string(1e-3 * milliseconds) + " ", arguments);
}

void EvalToolTest::expectFailure(const std::vector<std::string>& arguments, int exit_code,
                                 const std::string& words) const {
  const EvalResult result = run(arguments);
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("epcc_eval: ", 0), 0U) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
}

std::string EvalToolTest::read(const std::string& name) const {
  std::ifstream file(path(name), std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void EvalToolTest::write(const std::string& name, const std::string& content) const {
  fs::create_directories(path(name).parent_path());
  std::ofstream(path(name), std::ios::binary) << content;
}

void EvalToolTest::writeFrame(const std::string& folder, const std::string& name, unsigned seed) const {
  fs::create_directories(path(folder));
  writeLabelledFrame(path(folder).string(), tinyFrame(name, seed));
}

nlohmann::json EvalToolTest::row(const std::string& out, const std::string& dataset, const std::string& method) const {
  const auto summary = nlohmann::json::parse(read(out + "/summary.json"));
  for (const auto& entry : summary.at("rows"))
    if (entry.at("dataset") == dataset && entry.at("method") == method) return entry;
  ADD_FAILURE() << "no row " << dataset << ", " << method;
  return {};
}

std::vector<std::vector<std::string>> EvalToolTest::frames(const std::string& out) const {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(read(out + "/frames.csv"));
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

std::map<std::string, std::string> EvalToolTest::report(const std::string& out) const {
  // Tables in text: the cell below "median_ms", the last of fifteen. CSV: the sixteenth; errors in the tests' frames
  // come after it.
  const std::pair<const char*, const char*> times[] = {
      {"summary.json", R"("median_ms": [^\n]*)"},
      {"summary.md", R"(((?:^|\n)\|(?: [^|\n]* \|){14}) [^|\n]* \|(?=\n))"},
      {"summary.tex", R"(((?:^|\n)(?:[^&\n]*&){14})[^&\n]*\\\\(?=\n))"},
      {"report.html", R"((<td class="r time">)[^<]*)"},
      {"frames.csv", R"(((?:^|\n)(?:[^,\n]*,){15})[^,\n]*)"}};
  std::map<std::string, std::string> files;
  for (const auto& [name, pattern] : times)
    files[name] = std::regex_replace(read(out + "/" + name), std::regex(pattern), "$1");
  return files;
}

}  // namespace epcc::test
