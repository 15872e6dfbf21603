// SPDX-License-Identifier: BSD-3-Clause
// What is typed, at the limits of docs/reference/limits.md: the last that is allowed gets as far as an output folder
// that is not there or an input that is missing, the first that is not is wrong usage. And names that are too long.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "datasets/files/labelled_frame.h"
#include "tests/support/run_tool.h"
#include "tests/support/tiny_frames.h"

namespace epcc::test {
namespace {

using Arguments = std::vector<std::string>;

/// `{}` in the arguments stands for the number.
struct Range {
  const char* program;
  Arguments arguments;
  std::vector<std::string> allowed, refused;
};

const Range kRanges[] = {
    {"epcc_eval", {"none", "--jobs", "{}"}, {"0", "1024"}, {"-1", "1025"}},
    {"epcc_eval", {"none", "--shard", "1/{}"}, {"1", "1000000"}, {"0", "1000001"}},
    {"epcc_eval", {"none", "--seeds", "{}"}, {"1", "1000"}, {"0", "1001"}},
    {"epcc_eval", {"none", "--repeatability", "{}"}, {"1", "10000"}, {"0", "10001"}},
    {"epcc_compare", {"--jobs", "{}", "--out", "a/b/c/none"}, {"1024"}, {"-1", "1025"}},
    {"epcc_lines", {"none", "--out", "out", "--jobs", "{}"}, {"0", "256"}, {"-1", "257"}},
    {"epcc_segment", {"none.pcd", "--threads", "{}"}, {"1", "256"}, {"0", "257"}},
    {"epcc_track", {"none", "--out", "out", "--threads", "{}"}, {"1", "256"}, {"0", "257"}},
    {"epcc_track", {"none", "--out", "out", "--frames", "{}"}, {"1", "100000000"}, {"0", "100000001"}},
    {"epcc_scene", {"a", "--out", "none/out", "--count", "{}"}, {"1", "100000"}, {"0", "100001"}},
    {"epcc_scene", {"a", "--out", "none/out", "--height", "1", "--width", "{}"}, {"1", "16384"}, {"0", "16385"}},
    {"epcc_scene", {"a", "--out", "none/out", "--width", "16000", "--height", "{}"}, {"4000"}, {"4001"}},
};

class ToolLimits : public TempFolderTest {
 protected:
  ToolResult run(const Range& range, const std::string& number) const {
    Arguments arguments = range.arguments;
    for (std::string& word : arguments)
      if (const std::size_t at = word.find("{}"); at != std::string::npos) word.replace(at, 2, number);
    return runTool(range.program, arguments, folder());
  }
};

TEST_F(ToolLimits, TheLastThatIsAllowedPassesTheFirstThatIsNotIsUsage) {
  write("none/out", "a file where the folder would be");
  write("a/b/c", "another");
  for (const Range& range : kRanges) {
    for (const std::string& number : range.allowed) {
      const ToolResult result = run(range, number);
      EXPECT_TRUE(result.exit_code == 3 || result.exit_code == 4)
          << range.program << ' ' << range.arguments.back() << ' ' << number << ": " << result.exit_code << result.err;
    }
    for (const std::string& number : range.refused) {
      SCOPED_TRACE(range.arguments.back() + ' ' + number);
      expectFailure(run(range, number), range.program, 2, "");
    }
  }
}

TEST_F(ToolLimits, NamesAreAsLongAsTheFileSystemAllows) {
  std::filesystem::create_directories(path("rooms"));
  const std::string longest(255 - std::string("_labels.png").size(), 'n');
  writeLabelledFrame(path("rooms"), tinyFrame(longest, 1));
  const std::string input = "rooms/" + longest + "_depth.png";
  EXPECT_EQ(runTool("epcc_segment", {input, "--planes", std::string(250, 'p') + ".json"}, folder()).exit_code, 0);
  EXPECT_TRUE(exists(std::string(250, 'p') + ".json"));
  expectFailure(runTool("epcc_segment", {std::string(256, 'n') + ".pcd"}, folder()), "epcc_segment", 3,
                "name too long");
  std::string deep;
  while (deep.size() < 4096) deep += "folder/";
  expectFailure(runTool("epcc_segment", {deep + "a.pcd"}, folder()), "epcc_segment", 3, "name too long");
  const ToolResult output = runTool("epcc_segment", {input, "--planes", std::string(256, 'p') + ".json"}, folder());
  EXPECT_EQ(output.exit_code, 4) << output.err;
  EXPECT_NE(output.err.find("name too long"), std::string::npos) << output.err;
}

TEST_F(ToolLimits, AFileThatMayNotGrowIsAnErrorLikeAFullDisk) {
  // The limit, 3 MB, holds for the counts of covered lines too, of which the largest take half of it; the cloud has 7.
  ASSERT_EQ(runTool("epcc_scene", {"a", "--width", "1280", "--height", "960", "--out", "rooms"}, folder()).exit_code,
            0);
  const std::vector<std::string> frames = listLabelledFrames(path("rooms"));
  ASSERT_EQ(frames.size(), 1U);
  const std::string input = "rooms/" + frames[0] + "_depth.png";
  const ToolResult result = runTool("epcc_segment", {input, "--cloud", "c.pcd"}, folder(), "ulimit -f 6000; ");
  expectFailure(result, "epcc_segment", 4, "c.pcd: file: File too large");
  EXPECT_EQ(names(), std::vector<std::string>{"rooms"});
}

}  // namespace
}  // namespace epcc::test
