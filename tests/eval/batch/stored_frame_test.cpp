// SPDX-License-Identifier: BSD-3-Clause
// A frame's results to their file and back; jobs and times in little memory.
#include "eval/batch/stored_frame.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "eval/experiment/frame_jobs.h"
#include "eval/experiment/time_counts.h"
#include "eval/report/evaluation_report.h"
#include "tests/support/temp_folder.h"
#include "tests/support/tiny_frames.h"

namespace {

using namespace epcc;

class StoredFrames : public test::TempFolderTest {};

TEST_F(StoredFrames, ComeBackAsTheyWere) {
  StoredFrame frame{
      1234567, "rooms/f", {{"rooms", "f", "m", {}, 12.345, ""}, {"rooms", "f", "n", {}, {}, "a \"b\", c"}}};
  FrameMeasures& m = frame.records[0].measures;
  m.paper = {1, 2, 3, 4, 5};
  m.segcomp = {6, 7, 8, 9, 10};
  m.instances = {1, 2, 11, 12, 13, 9000000000L, 15};
  m.planes = {16, 17, 18};
  storeFrame(folder(), frame);
  EXPECT_TRUE(exists("results/rooms/001234/567.json"));
  const auto back = loadFrame(folder(), "rooms", 1234567, {"m", "n"});
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->file_name, "rooms/f");
  ASSERT_EQ(back->records.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(frameLine(back->records[i]), frameLine(frame.records[i]));
  EXPECT_EQ(back->records[0].measures.instances.precision(), m.instances.precision());
  EXPECT_EQ(back->records[0].measures.instances.recall(), m.instances.recall());
}

TEST_F(StoredFrames, ADoubtComesBackAndOlderFilesHaveNone) {
  storeFrame(folder(), {7, "f", {{"rooms", "f", "m", {}, {}, "", "is this a depth image?"}}});
  const std::string file = "results/rooms/000000/007.json", kept = ",\"doubt\":\"is this a depth image?\"";
  EXPECT_EQ(loadFrame(folder(), "rooms", 7, {"m"}).value().records[0].doubt, "is this a depth image?");
  std::string older = read(file);
  ASSERT_NE(older.find(kept), std::string::npos) << older;
  write(file, older.erase(older.find(kept), kept.size()));
  EXPECT_EQ(loadFrame(folder(), "rooms", 7, {"m"}).value().records[0].doubt, "");
}

TEST_F(StoredFrames, NothingWhereThereIsNone) {
  EXPECT_FALSE(loadFrame(folder(), "rooms", 0, {"m"}).has_value());
}

TEST_F(StoredFrames, AResultOfAnotherFrameIsNone) {
  storeFrame(folder(), {7, "f", {{"rooms", "f\xff", "m", {}, {}, ""}}});
  EXPECT_TRUE(loadFrame(folder(), "rooms", 7, {"m"}, "f\xff").has_value());
  EXPECT_FALSE(loadFrame(folder(), "rooms", 7, {"m"}, "g").has_value());
  std::filesystem::create_directories(path("results/halls/000000"));
  write("results/halls/000000/007.json", read("results/rooms/000000/007.json"));
  EXPECT_FALSE(loadFrame(folder(), "halls", 7, {"m"}).has_value());
}

TEST_F(StoredFrames, ADamagedNumberIsNoResult) {
  storeFrame(folder(), {7, "f", {{"rooms", "f", "m", {}, 1.0, ""}}});
  const std::string file = "results/rooms/000000/007.json", good = read(file);
  for (const char* word : {"\"N\":", "\"noise\":", "\"iou_sum_millionths\":", "\"microseconds\":"}) {
    const std::size_t begin = good.find(word) + std::string(word).size();
    ASSERT_LT(begin, good.size()) << word;
    const auto with = [&](const std::string& number) {
      write(file, std::string(good).replace(begin, good.find_first_of(",}", begin) - begin, number));
      return loadFrame(folder(), "rooms", 7, {"m"}).has_value();
    };
    EXPECT_TRUE(with("1000000000000000"));
    for (const char* number : {"-1", "1.5", "1e3", "1000000000000001", "9223372036854775808", "1e300", "\"1\"", "null"})
      EXPECT_FALSE(with(number)) << word << number;
  }
}

TEST_F(StoredFrames, WhatIsNoFileOrTooLargeIsNoResult) {
  const std::string file = "results/rooms/000000/007.json";
  storeFrame(folder(), {7, "f", {{"rooms", "f", "m", {}, {}, ""}}});
  write(file, read(file) + std::string(17 << 20, ' '));
  EXPECT_FALSE(loadFrame(folder(), "rooms", 7, {"m"}).has_value());
  std::filesystem::remove(path(file));
  ASSERT_EQ(::mkfifo(path(file).c_str(), 0600), 0);
  EXPECT_FALSE(loadFrame(folder(), "rooms", 7, {"m"}).has_value());
}

TEST_F(StoredFrames, AResultOfOtherMethodsIsNone) {
  storeFrame(folder(), {7, "f", {{"rooms", "f", "m", {}, {}, ""}, {"rooms", "f", "n", {}, {}, ""}}});
  EXPECT_TRUE(loadFrame(folder(), "rooms", 7, {"m", "n"}).has_value());
  for (const std::vector<std::string>& others :
       {std::vector<std::string>{"m"}, {"n", "m"}, {"m", "n", "o"}, {"m", "q"}})
    EXPECT_FALSE(loadFrame(folder(), "rooms", 7, others).has_value()) << others.back();
}

TEST(TimeCounts, MedianOfManyTimesInTheirMicroseconds) {
  TimeCounts times, more;
  for (int i = 0; i < 1000; ++i) times.add(0.001 * (i % 10));
  EXPECT_DOUBLE_EQ(times.medianMs().value(), 0.0045);
  for (int i = 0; i < 2000; ++i) more.add(7.0);
  times += more;
  EXPECT_DOUBLE_EQ(times.medianMs().value(), 7.0);
}

TEST(FrameJobs, KeptJobsKeepPositionAndName) {
  std::vector<std::unique_ptr<FrameSource>> sources;
  using Frames = std::vector<LabelledFrame>;
  sources.push_back(
      std::make_unique<test::MemorySource>("a", Frames{test::tinyFrame("x", 1), test::tinyFrame("y", 1)}));
  sources.push_back(std::make_unique<test::MemorySource>("none", Frames{}));
  sources.push_back(
      std::make_unique<test::MemorySource>("b", Frames{test::tinyFrame("y", 1), test::tinyFrame("z", 1)}));
  FrameJobs jobs = listJobs(sources);
  jobs.keepIf([](const FrameJob& job) { return job.position % 2 == 0; });
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_EQ(jobs[0].file_name, "x");
  EXPECT_EQ(jobs[1].file_name, "b/y");
  EXPECT_EQ(jobs[1].position, 2U);
  EXPECT_EQ(jobs[1].index, 0U);
  jobs.keepFirst(1);
  EXPECT_EQ(jobs.size(), 1U);
}

}  // namespace
