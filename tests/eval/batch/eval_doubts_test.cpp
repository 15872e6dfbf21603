// SPDX-License-Identifier: BSD-3-Clause
// Doubtful frames: told once for each data set, whole or in shards, and never a failure.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/eval/batch/eval_runner.h"
#include "tests/support/swapped_bytes.h"

namespace {

using epcc::test::EvalToolTest;
using Words = std::vector<std::string>;

const char kRooms[] = "rooms: 2 frames are doubtful; f1: depth: the two bytes of each value are in the wrong order";
const char kHalls[] = "halls: 1 frame is doubtful; f0: depth: the two bytes of each value are in the wrong order";

long countOf(const std::string& words, const std::string& text) {
  long count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

class EvalDoubts : public EvalToolTest {
 protected:
  EvalDoubts() {
    for (const char* name : {"f0", "f1", "f2"}) writeFrame("rooms", name);
    for (const char* name : {"f0", "f1"}) writeFrame("halls", name, 2);
    for (const char* file : {"rooms/f1", "rooms/f2", "halls/f0"})
      epcc::test::swapBytesOf(path(std::string(file) + "_depth.png"));
  }
  epcc::test::ToolResult evaluate(const Words& more) const {
    Words words = {"rooms", "halls", "--methods", "epcc-paper,omps", "--strict"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
};

TEST_F(EvalDoubts, AreToldOnceForEachDataSetAndAreNoErrors) {
  for (const Words& more : {Words(), Words{"--out", "o", "--jobs", "3"}}) {
    const auto result = evaluate(more);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(countOf(kRooms, result.err), 1) << result.err;
    EXPECT_EQ(countOf(kHalls, result.err), 1) << result.err;
    EXPECT_EQ(countOf("\n", result.err), 2) << result.err;
  }
  EXPECT_EQ(countOf(std::string("| ") + kRooms, read("o/summary.md")), 1) << read("o/summary.md");
  EXPECT_EQ(countOf(std::string("| ") + kHalls, read("o/summary.md")), 1);
  EXPECT_EQ(countOf("| error |", read("o/summary.md")), 0);
  EXPECT_EQ(countOf("<h2>Doubts</h2>", read("o/report.html")), 1);
  EXPECT_EQ(countOf("<h2>Errors</h2>", read("o/report.html")), 0);
  EXPECT_EQ(countOf(std::string("<li>") + kRooms, read("o/report.html")), 1);
  const auto doubtful = nlohmann::json::parse(read("o/summary.json")).at("doubtful");
  ASSERT_EQ(doubtful.size(), 2U);
  EXPECT_EQ(doubtful[0].at("dataset"), "rooms");
  EXPECT_EQ(doubtful[0].at("frames"), 2);
  EXPECT_EQ(doubtful[0].at("first"), "f1");
  EXPECT_EQ(row("o", "rooms", "omps").at("errors"), 0);
}

TEST_F(EvalDoubts, AreKeptInShards) {
  ASSERT_EQ(evaluate({"--out", "whole"}).exit_code, 0);
  for (const char* shard : {"1", "2", "3"})
    ASSERT_EQ(evaluate({"--out", std::string("s") + shard, "--shard", std::string(shard) + "/3"}).exit_code, 0);
  const auto merged = run({"merge", "s3", "s1", "s2", "--out", "m", "--strict"});
  EXPECT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(report("m"), report("whole"));
  EXPECT_EQ(countOf(kRooms, read("m/summary.md")), 1) << read("m/summary.md");
}

TEST_F(EvalDoubts, AreKeptByARunThatIsGoneOnWith) {
  ASSERT_EQ(evaluate({"--out", "o"}).exit_code, 0);
  const auto before = report("o");
  std::filesystem::remove(path("o/results/rooms/000000/002.json"));
  std::filesystem::remove(path("o/summary.md"));
  EXPECT_EQ(evaluate({"--out", "o", "--resume"}).exit_code, 0);
  EXPECT_EQ(report("o"), before);
}

TEST_F(EvalDoubts, WithoutAnyNothingIsSaid) {
  const auto result = run({"halls", "--methods", "epcc-paper", "--out", "o"});
  ASSERT_EQ(result.exit_code, 0);
  epcc::test::swapBytesOf(path("halls/f0_depth.png"));
  const auto mended = run({"halls", "--methods", "epcc-paper", "--out", "p"});
  EXPECT_NE(result.err, "");
  EXPECT_EQ(mended.err, "");
  EXPECT_EQ(countOf("oubt", read("p/summary.md") + read("p/summary.json") + read("p/report.html")), 0);
}

}  // namespace
