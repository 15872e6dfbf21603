// SPDX-License-Identifier: BSD-3-Clause
// Every program of eval/tools with less address space than its work takes: lines that say so, exit code 3.
#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "datasets/files/labelled_frame.h"
#include "tests/eval/view/virtual_display.h"
#include "tests/support/address_limit.h"
#include "tests/support/run_tool.h"
#include "tests/support/tiny_frames.h"

namespace epcc::test {
namespace {

constexpr long kMegabyte = 1024;  // of ulimit, which counts kilobytes
constexpr long kMostMegabytes = 4096;

struct ToolCase {
  const char* program;
  std::vector<std::string> arguments;
};

const ToolCase kCases[] = {
    {"epcc_segment", {"rooms", "--out", "out"}},
    {"epcc_scene", {"a", "--out", "out"}},
    {"epcc_track", {"rooms", "--pose-free", "--out", "out"}},
    {"epcc_noise", {"rooms", "--out", "sensor"}},
    {"epcc_lines", {"a.log", "--out", "out"}},
    {"epcc_eval", {"rooms", "--methods", "epcc", "--out", "out"}},
    {"epcc_compare", {"--scenes", "a", "--seeds", "1", "--out", "out"}},
    {"epcc_accuracy", {"--data", "rooms", "--seeds", "1", "--out", "out"}},
    {"epcc_consistency", {"--runs", "1", "--out", "out"}},
    {"epcc_line_study", {"--plans", "1", "--scans", "1", "--map", "map.png"}},
#ifdef EPCC_WITH_VIEW
    {"epcc_view", {"hall", "--snapshot", "view.png"}},
#endif
};

void PrintTo(const ToolCase& tool, std::ostream* out) {
  *out << tool.program;
}

class ToolsOutOfMemory : public TempFolderTest, public testing::WithParamInterface<ToolCase> {
 protected:
  void SetUp() override {
    TempFolderTest::SetUp();
    std::filesystem::create_directories(path("rooms"));
    for (unsigned i = 0; i < 3; ++i) writeLabelledFrame(path("rooms"), tinyFrame("f" + std::to_string(i), i));
    std::string log;
    for (int scan = 0; scan < 40; ++scan) {
      log += "FLASER 180";
      for (int beam = 0; beam < 180; ++beam) log += " " + std::to_string(2.0 + 0.01 * ((beam * 7 + scan) % 5));
      log += " 0 0 0 0 0 0 " + std::to_string(scan) + " h " + std::to_string(scan) + "\n";
    }
    write("a.log", log);
    LabelledFrame hall = tinyFrame("hall", 1);  // too large to be read, before there is a window
    hall.camera.camera.width = hall.camera.camera.height = 4000;
    hall.depth = DepthImage(4000, 4000);
    hall.labels = LabelImage();
    std::filesystem::create_directories(path("hall"));
    if (std::string(GetParam().program) == "epcc_view") writeLabelledFrame(path("hall"), hall);
  }
  ToolResult runWithin(long kilobytes, const std::vector<std::string>& arguments) const {
    std::filesystem::remove_all(path("out"));  // epcc_eval goes on with results only when asked to
    return runTool(GetParam().program, arguments, folder(),
                   "ulimit -v " + std::to_string(kilobytes) + " && " + before_);
  }
  std::string before_;
  /// The least address space, to a megabyte, in which the program can be loaded and tells its version.
  long leastToStart() const {
    long too_little = 0, enough = kMostMegabytes;
    while (enough - too_little > 1) {
      const long middle = (too_little + enough) / 2;
      (runWithin(middle * kMegabyte, {"--version"}).exit_code == 0 ? enough : too_little) = middle;
    }
    return enough * kMegabyte;
  }
};

TEST_P(ToolsOutOfMemory, IsOneLineAndExitCode3) {
  EPCC_NEED_ADDRESS_LIMIT();
  std::optional<VirtualDisplay> display;
  if (std::string(GetParam().program) == "epcc_view") {
    display.emplace();
    if (!display->exists()) GTEST_SKIP() << "Xvfb not found (Debian package xvfb)";
    before_ = display->command();
  }
  const long least = leastToStart();
  ASSERT_LT(least, kMostMegabytes * kMegabyte);
  int refused = 0;
  for (long more = 0; more <= 64 * kMegabyte && refused < 8; more += more < 6 * kMegabyte ? kMegabyte / 4 : kMegabyte) {
    const ToolResult result = runWithin(least + more, GetParam().arguments);
    SCOPED_TRACE(std::to_string(least + more) + " kB: " + result.err);
    if (result.exit_code == 0) break;
    ASSERT_EQ(result.exit_code, 3);
    if (result.err.find("display:") != std::string::npos) continue;  // X11 does not say why it opens none
    std::istringstream lines(result.err);                            // one a frame
    for (std::string line; std::getline(lines, line);)
      EXPECT_EQ(line.rfind(std::string(GetParam().program) + ": ", 0), 0U) << line;
    EXPECT_NE(result.err.find("memory"), std::string::npos);
    ++refused;
  }
  EXPECT_GT(refused, 0) << "it needs no more than to start";
}

INSTANTIATE_TEST_SUITE_P(Each, ToolsOutOfMemory, testing::ValuesIn(kCases),
                         [](const auto& test) { return std::string(test.param.program); });

}  // namespace
}  // namespace epcc::test
