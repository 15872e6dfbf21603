// SPDX-License-Identifier: BSD-3-Clause
// Generated frames, and starting the program.
#include "tests/eval/batch/eval_runner.h"

#include <filesystem>
#include <regex>
#include <sstream>

#include "tests/support/tiny_frames.h"

namespace epcc::test {

ToolResult EvalToolTest::runShell(const std::string& before, const std::vector<std::string>& arguments) const {
  return runTool("epcc_eval", arguments, folder(), before);
}

ToolResult EvalToolTest::run(const std::vector<std::string>& arguments) const {
  return runShell("", arguments);
}

void EvalToolTest::expectFailure(const std::vector<std::string>& arguments, int exit_code,
                                 const std::string& words) const {
  test::expectFailure(run(arguments), "epcc_eval", exit_code, words);
}

void EvalToolTest::writeFrame(const std::string& folder, const std::string& name, unsigned seed) const {
  std::filesystem::create_directories(path(folder));
  writeLabelledFrame(path(folder), tinyFrame(name, seed));
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
