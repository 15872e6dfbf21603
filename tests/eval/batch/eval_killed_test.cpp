// SPDX-License-Identifier: BSD-3-Clause
// Runs that are killed where a file is about to get its name, again and again, and gone on with.
#include <fcntl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "eval/batch/eval_command.h"
#include "tests/eval/batch/eval_runner.h"

namespace {

/// The process kills itself at its so many-th rename; 0: never.
int deadly_rename = 0;

}  // namespace

/// Takes the C library's place in this program, std::filesystem::rename() included.
extern "C" __attribute__((visibility("default"))) int rename(const char* from, const char* to) noexcept {
  if (deadly_rename > 0 && --deadly_rename == 0) ::raise(SIGKILL);
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

namespace {

namespace fs = std::filesystem;

class EvalKilled : public epcc::test::EvalToolTest {
 protected:
  /// Runs epcc_eval in a process of its own, which is killed at a rename; the exit code, or 137 if it was killed.
  int runAndKill(const std::vector<std::string>& arguments, int at_rename) const {
    const pid_t process = ::fork();
    if (process == 0) {
      fs::current_path(folder());
      deadly_rename = at_rename;
      const auto result = epcc::test::callTool(epcc::evalMain, "epcc_eval", arguments);
      std::_Exit(result.exit_code);
    }
    int status = -1;
    ::waitpid(process, &status, 0);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  std::size_t files(const std::string& folder, const std::string& extension = "") const {
    std::size_t count = 0;
    if (!exists(folder)) return 0;
    for (const auto& entry : fs::recursive_directory_iterator(path(folder)))
      if (entry.is_regular_file() && (extension.empty() || entry.path().extension() == extension)) ++count;
    return count;
  }
};

TEST_F(EvalKilled, AgainAndAgainTheReportIsThatOfOneRun) {
  for (unsigned i = 0; i < 30; ++i) writeFrame("rooms", "f" + std::to_string(i), i);
  for (unsigned i = 0; i < 5; ++i) writeFrame("halls", "f" + std::to_string(i), i);
  write("rooms/f7_depth.png", "broken");
  std::vector<std::string> arguments = {"rooms", "halls", "--methods", "epcc-paper,omps", "--resume", "--out", "whole"};
  ASSERT_EQ(run(arguments).exit_code, 0);

  arguments.back() = "pieces";
  int runs = 0, partly = 0, half_written = 0;
  while (runAndKill(arguments, ++runs) == 137) {
    ASSERT_LT(runs, 100) << "each run goes further than the one before";
    const std::size_t done = files("pieces/results", ".json");
    partly += done > 0 && done < 35 ? 1 : 0;
    half_written += files("pieces", ".tmp") > 0 ? 1 : 0;
  }
  EXPECT_GE(partly, 10);
  EXPECT_GE(half_written, 10);
  EXPECT_EQ(report("pieces"), report("whole"));
  EXPECT_EQ(files("pieces"), files("whole")) << "nothing half written is left";
  EXPECT_EQ(row("pieces", "rooms", "omps").at("errors"), 1);
}

}  // namespace
