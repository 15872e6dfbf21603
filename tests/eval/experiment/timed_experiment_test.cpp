// SPDX-License-Identifier: BSD-3-Clause
// Frames in processes of their own: what takes too long or ends its process costs its frame and no other.
#include "eval/experiment/timed_experiment.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <new>

#include "datasets/support/input_error.h"
#include "tests/support/tiny_frames.h"

namespace {

using namespace epcc;
using test::tinyFrame;

/// Finds the planes of the truth; the frame's name may ask for something else.
class MoodySegmenter : public PlaneSegmenter {
 public:
  std::string name() const override { return "moody"; }

 protected:
  bool run(const SegmenterInput& input, PlaneSegmentation& result) override {
    const std::string mood = input.name.substr(0, input.name.find('-'));
    while (mood == "endless") ::pause();
    if (mood == "killed") std::raise(SIGKILL);
    if (mood == "leaves") std::_Exit(7);
    if (mood == "large") throw std::bad_alloc();
    if (mood == "fails") return fail("no luck today");
    const LabelledFrame truth = tinyFrame("", 0);
    std::copy(truth.labels.data.begin(), truth.labels.data.end(), result.labels.begin());
    fitLabels(input, 3, result);
    return true;
  }
};

Method moody() {
  return {"moody", [] { return std::make_unique<MoodySegmenter>(); }, true};
}

std::vector<std::unique_ptr<FrameSource>> framesCalled(const std::vector<std::string>& names) {
  std::vector<LabelledFrame> frames;
  for (const std::string& name : names) frames.push_back(tinyFrame(name, 1));
  std::vector<std::unique_ptr<FrameSource>> sources;
  sources.push_back(std::make_unique<test::MemorySource>("rooms", std::move(frames)));
  return sources;
}

/// Long for a frame of 80x60, even on a busy machine, and short for whoever waits for the tests.
constexpr double kLimit = 4.0;

ExperimentOptions limited(int jobs, double seconds = kLimit) {
  ExperimentOptions options;
  options.jobs = jobs;
  options.frame_timeout = seconds;
  return options;
}

/// Errors by frame, in the order in which they came, "" for a frame that was scored.
std::vector<std::string> errorsOf(const std::vector<std::string>& names, const ExperimentOptions& options) {
  std::vector<std::string> errors;
  std::size_t i = 0;
  runExperiment(listJobs(framesCalled(names)), {moody()}, options, {}, [&](const std::vector<FrameRecord>& records) {
    ASSERT_EQ(records.size(), 1U);
    EXPECT_EQ(records[0].frame, names.at(i++));
    EXPECT_EQ(records[0].measures.segcomp.correct, records[0].error.empty() ? 3 : 0);
    EXPECT_EQ(records[0].ms.has_value(), records[0].error.empty());
    errors.push_back(records[0].error);
  });
  return errors;
}

using Words = std::vector<std::string>;

TEST(TimedExperiment, AFrameThatNeverEndsIsGivenUpAndTheOthersGoOn) {
  const std::string late = "takes longer than 4 s (--frame-timeout)";
  EXPECT_EQ(errorsOf({"a", "endless", "b"}, limited(1)), (Words{"", late, ""}));
  EXPECT_EQ(errorsOf({"endless-1", "a", "endless-2", "b", "c"}, limited(3)), (Words{late, "", late, "", ""}));
}

TEST(TimedExperiment, AProcessThatEndsCostsItsFrame) {
  for (const int jobs : {1, 2})
    EXPECT_EQ(errorsOf({"a", "killed", "leaves", "b"}, limited(jobs, 600)),
              (Words{"", "its process ended: signal 9, Killed", "its process ended: exit code 7", ""}));
}

TEST(TimedExperiment, ErrorsAreThoseOfARunWithoutLimit) {
  const Words names = {"a", "fails", "large", "b"};
  const Words errors = {"", "no luck today", "needs more memory than there is", ""};
  EXPECT_EQ(errorsOf(names, {}), errors);
  EXPECT_EQ(errorsOf(names, limited(2, 600)), errors);
}

TEST(TimedExperiment, OnlyLostFramesAreHandedOutHere) {
  std::vector<FrameResult> here;
  const auto done = [&](const FrameResult& result) { here.push_back(result); };
  runExperiment(listJobs(framesCalled({"a", "killed", "fails"})), {moody(), moody()}, limited(2, 600), done, {});
  ASSERT_EQ(here.size(), 1U);
  EXPECT_TRUE(here[0].lost);
  EXPECT_EQ(here[0].index, 1U);
  EXPECT_EQ(here[0].file_name, "killed");
  ASSERT_EQ(here[0].records.size(), 2U);
  EXPECT_EQ(here[0].records[1].error, here[0].reading_error);
}

TEST(TimedExperiment, WhatIsThrownInAProcessEndsTheRun) {
  const auto sources = framesCalled({"a", "b", "c"});
  const auto full = [](const FrameResult&) { throw OutputError("disk", "space", "none left"); };
  try {
    runExperiment(listJobs(sources), {moody()}, limited(2, 600), full, {});
    ADD_FAILURE() << "no error";
  } catch (const OutputError& error) {
    EXPECT_STREQ(error.what(), "disk: space: none left");
  }
  const auto broken = [](const std::exception& error) {
    return Method{"broken",
                  [&error]() -> std::unique_ptr<PlaneSegmenter> {
                    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) throw std::bad_alloc();
                    throw std::runtime_error(error.what());
                  },
                  true};
  };
  const std::bad_alloc no_memory;
  const std::runtime_error other("what it was");
  EXPECT_THROW(runExperiment(listJobs(sources), {broken(no_memory)}, limited(1, 600), {}, {}), std::bad_alloc);
  EXPECT_THROW(runExperiment(listJobs(sources), {broken(other)}, limited(1, 600), {}, {}), std::runtime_error);
}

TEST(TimedExperiment, AnswersLongerThanAPipeComeWhole) {
  const std::vector<Method> methods(3000, moody());
  std::size_t scored = 0;
  runExperiment(listJobs(framesCalled({"a"})), methods, limited(1, 600), {}, [&](const auto& records) {
    for (const FrameRecord& record : records) scored += record.error.empty() ? 1 : 0;
  });
  EXPECT_EQ(scored, methods.size());
}

TEST(TimedExperiment, NoJobsIsNoError) {
  EXPECT_TRUE(errorsOf({}, limited(2)).empty());
}

}  // namespace
