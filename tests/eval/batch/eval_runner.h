// SPDX-License-Identifier: BSD-3-Clause
// Runs epcc_eval in a folder of its own on tiny frames made on the spot.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/run_tool.h"

namespace epcc::test {

class EvalToolTest : public TempFolderTest {
 protected:
  /// Runs the program inside the folder.
  ToolResult run(const std::vector<std::string>& arguments) const;
  /// The same, and checks that it fails as promised (run_tool.h).
  void expectFailure(const std::vector<std::string>& arguments, int exit_code, const std::string& words) const;

  /// FOLDER/NAME_depth.png, _labels.png and .json: the room of tiny_frames.h with noise after the seed.
  void writeFrame(const std::string& folder, const std::string& name, unsigned seed = 1) const;

  /// The row of OUT/summary.json.
  nlohmann::json row(const std::string& out, const std::string& dataset, const std::string& method) const;
  /// The cells of OUT/frames.csv without quotes in them, heading first.
  std::vector<std::vector<std::string>> frames(const std::string& out) const;
  /// The report's files by name, with every time taken out: equal for equal results.
  std::map<std::string, std::string> report(const std::string& out) const;

  /// Runs it as an argument of a shell's words `before`.
  ToolResult runShell(const std::string& before, const std::vector<std::string>& arguments) const;
};

}  // namespace epcc::test
