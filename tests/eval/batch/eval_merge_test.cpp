// SPDX-License-Identifier: BSD-3-Clause
// Shards: any number of them gives the same report; what is missing or doubled is named.
#include <algorithm>

#include "tests/eval/batch/eval_runner.h"

namespace {

namespace fs = std::filesystem;
using epcc::test::EvalToolTest;
using Words = std::vector<std::string>;

class EvalMerge : public EvalToolTest {
 protected:
  EvalMerge() {
    for (unsigned i = 0; i < 7; ++i) writeFrame("rooms", "f" + std::to_string(i), i);
    for (unsigned i = 0; i < 3; ++i) writeFrame("halls", "f" + std::to_string(i), 20 + i);
    write("rooms/f4_labels.png", "broken");
  }
  Words arguments(const std::string& out, const std::string& shard) const {
    return {"rooms", "halls", "--methods", "epcc-paper,omps", "--out", out, "--shard", shard};
  }
  /// Runs every shard and returns their folders.
  Words shards(int count) const {
    Words folders;
    for (int i = 1; i <= count; ++i) {
      folders.push_back("s" + std::to_string(count) + "_" + std::to_string(i));
      EXPECT_EQ(run(arguments(folders.back(), std::to_string(i) + "/" + std::to_string(count))).exit_code, 0);
    }
    return folders;
  }
  static Words merge(const Words& folders, const std::string& out) {
    Words words = {"merge"};
    words.insert(words.end(), folders.begin(), folders.end());
    words.insert(words.end(), {"--out", out});
    return words;
  }
};

TEST_F(EvalMerge, AnyShardingGivesTheSameReport) {
  const auto whole = run({"rooms", "halls", "--methods", "epcc-paper,omps", "--out", "whole", "--jobs", "2"});
  ASSERT_EQ(whole.exit_code, 0);
  for (const int count : {1, 2, 3, 7}) {
    Words folders = shards(count);
    std::reverse(folders.begin(), folders.end());
    const auto result = run(merge(folders, "merged"));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "epcc_eval: 2 errors, 18 results scored\n");
    EXPECT_EQ(report("merged"), report("whole")) << count;
  }
  EXPECT_EQ(row("merged", "rooms", "omps").at("frames"), 7);
  EXPECT_EQ(run({"merge", "whole", "--out", "one", "--strict"}).exit_code, 3);
}

TEST_F(EvalMerge, ShardsWithoutFramesAreDone) {
  const Words folders = shards(12);
  EXPECT_EQ(run(merge(folders, "merged")).exit_code, 0);
  EXPECT_EQ(row("merged", "halls", "omps").at("frames"), 3);
}

TEST_F(EvalMerge, RunsOverDifferentDataSetsAreJoined) {
  for (const std::string dataset : {"rooms", "halls"})
    ASSERT_EQ(run({dataset, "--methods", "epcc-paper,omps", "--out", dataset + "_out"}).exit_code, 0);
  ASSERT_EQ(run(arguments("whole", "1/1")).exit_code, 0);
  ASSERT_EQ(run(merge({"rooms_out", "halls_out"}, "merged")).exit_code, 0);
  EXPECT_EQ(report("merged"), report("whole"));
}

TEST_F(EvalMerge, DataSetsThatCannotBeOpenedAreNamedOnce) {
  const Words common = {"nowhere", "halls", "--methods", "omps", "--out"};
  const auto with = [&](const std::string& out, const std::string& shard) {
    Words words = common;
    words.insert(words.end(), {out, "--shard", shard});
    return run(words).exit_code;
  };
  ASSERT_EQ(with("whole", "1/1") + with("a", "1/2") + with("b", "2/2"), 0);
  const auto result = run(merge({"a", "b"}, "merged"));
  EXPECT_EQ(result.err, "epcc_eval: 1 error, 3 results scored\n");
  EXPECT_EQ(report("merged"), report("whole"));
  EXPECT_NE(read("merged/summary.md").find("nowhere"), std::string::npos);
}

TEST_F(EvalMerge, MissingAndDoubledShardsAreNamed) {
  const Words three = shards(3);
  expectFailure(merge({three[1]}, "m"), 3, "merge: data set rooms: shards: missing: 1/3, 3/3");
  expectFailure(merge({three[0], three[1], three[2], three[1]}, "m"), 3,
                "s3_2: shard: data set rooms, shard 2/3 is in s3_2 too");
  const Words two = shards(2);
  expectFailure(merge({three[0], two[0]}, "m"), 3, "data set rooms is in 2 shards here, in 3 elsewhere");
  EXPECT_FALSE(exists("m/summary.json"));
}

TEST_F(EvalMerge, MissingResultsAreNamed) {
  const Words two = shards(2);
  const std::string missing = "s2_2/results/rooms/000000/003.json";
  fs::remove(path(missing));
  expectFailure(merge(two, "m"), 3, missing + ": result: is missing; finish the run with --resume");
  write("s2_1/results/rooms/000000/002.json", "damaged");
  expectFailure(merge(two, "m"), 3, "is missing, with 1 more");
  EXPECT_FALSE(exists("m/frames.csv"));
}

TEST_F(EvalMerge, ShardsOfAnotherRunAreNamed) {
  const Words two = shards(2);
  ASSERT_EQ(run({"rooms", "halls", "--methods", "omps", "--out", "other", "--shard", "2/2"}).exit_code, 0);
  expectFailure(merge({two[0], "other"}, "m"), 3,
                "other: options: another run than s2_1: --methods was epcc-paper,omps, is omps");
  writeFrame("rooms", "f9");
  ASSERT_EQ(run(arguments("later", "2/2")).exit_code, 0);
  expectFailure(merge({two[0], "later"}, "m"), 3, "data set rooms had 7 frames, has 8");
}

TEST_F(EvalMerge, ARunsOwnReportIsKept) {
  const Words two = shards(2);
  ASSERT_EQ(run({"halls", "--methods", "omps", "--out", "own"}).exit_code, 0);
  const std::string before = read("own/summary.md");
  expectFailure(merge(two, "own"), 2, "merge: own has results of its own; choose another --out");
  EXPECT_EQ(read("own/summary.md"), before);
  ASSERT_EQ(run(merge(two, "m")).exit_code, 0);
  EXPECT_EQ(run(merge(two, "m")).exit_code, 0) << "a merged report may be made again";
}

TEST_F(EvalMerge, Usage) {
  EXPECT_EQ(run({"merge", "--help"}).exit_code, 0);
  expectFailure({"merge", "--out", "m"}, 2, "name at least one DIR");
  expectFailure({"merge", "rooms"}, 2, "--out DIR");
  expectFailure({"merge", "rooms", "--out", "./rooms"}, 2, "is one of the folders to be merged");
  expectFailure({"merge", "nowhere", "--out", "m"}, 3, "nowhere/run.json: ");
  expectFailure({"merge", "rooms", "--out", "m"}, 3, "rooms/run.json: ");
  for (const char* bad : {"0/3", "4/3", "1", "1/0", "-1/3", "a/b", "1/2/3", "99999999/99999999", ""})
    expectFailure({"rooms", "--shard", bad}, 2, "is not I/N");
}

}  // namespace
