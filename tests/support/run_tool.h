// SPDX-License-Identifier: BSD-3-Clause
// Calls a program, in the test's process or one of its own, and what its errors must look like.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/temp_folder.h"

namespace epcc::test {

/// What a program left.
struct ToolResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Calls `tool_main`, with the program's name as its first argument.
inline ToolResult callTool(int (*tool_main)(int, const char* const*, std::ostream&, std::ostream&),
                           const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<const char*> argv{program.c_str()};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  std::ostringstream out, err;
  const int code = tool_main(static_cast<int>(argv.size()), argv.data(), out, err);
  return {code, out.str(), err.str()};
}

inline std::string quotedForShell(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// The file of one of the project's programs: they are built into the folder of the tests' own.
inline std::string programFile(const std::string& program) {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / program).string();
}

/// Runs a program inside `folder`, as an argument of the shell's words `before`; -1 if a signal ended it.
inline ToolResult runTool(const std::string& program, const std::vector<std::string>& arguments,
                          const std::string& folder, const std::string& before = "") {
  const TempFolder outputs;
  std::string command = "cd " + quotedForShell(folder) + " && " + before + quotedForShell(programFile(program));
  for (const std::string& argument : arguments) command += " " + quotedForShell(argument);
  command += " >" + quotedForShell(outputs.path("out")) + " 2>" + quotedForShell(outputs.path("err")) + " </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytesOf(outputs.path("out")), bytesOf(outputs.path("err"))};
}

/// It failed as promised: the exit code, one line on stderr that starts with the program's name and has `words`, and
/// nothing on stdout.
inline void expectFailure(const ToolResult& result, const std::string& program, int exit_code,
                          const std::string& words) {
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind(program + ": ", 0), 0U) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
}

}  // namespace epcc::test
