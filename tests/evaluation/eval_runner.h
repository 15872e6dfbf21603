// SPDX-License-Identifier: BSD-3-Clause
// Runs epcc_eval in a folder of its own on tiny frames made on the spot.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace epcc::test {

struct EvalResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// A temporary folder, gone at the end of the test.
class EvalToolTest : public ::testing::Test {
 protected:
  EvalToolTest();
  ~EvalToolTest() override;

  /// Runs the program inside the folder.
  EvalResult run(const std::vector<std::string>& arguments) const;
  /// The same, and checks for the exit code, one line on stderr with `words`, and nothing on stdout.
  void expectFailure(const std::vector<std::string>& arguments, int exit_code, const std::string& words) const;

  /// Runs it and kills it (SIGKILL) after so many milliseconds; the exit code is 137 if it was still at work.
  EvalResult runAndKill(const std::vector<std::string>& arguments, int milliseconds) const;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
  std::string read(const std::string& name) const;
  void write(const std::string& name, const std::string& content) const;
  /// FOLDER/NAME_depth.png, _labels.png and .json: the room of tiny_frames.h with noise after the seed.
  void writeFrame(const std::string& folder, const std::string& name, unsigned seed = 1) const;

  /// The row of OUT/summary.json.
  nlohmann::json row(const std::string& out, const std::string& dataset, const std::string& method) const;
  /// The cells of OUT/frames.csv without quotes in them, heading first.
  std::vector<std::vector<std::string>> frames(const std::string& out) const;
  /// The report's files by name, with every time taken out: equal for equal results.
  std::map<std::string, std::string> report(const std::string& out) const;

  /// Runs it as an argument of a shell's words `before`.
  EvalResult runShell(const std::string& before, const std::vector<std::string>& arguments) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace epcc::test
