// SPDX-License-Identifier: BSD-3-Clause
// Frames through methods: scores, errors, order.
#include "eval/experiment/experiment.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <thread>

#include "datasets/sources/native_folder.h"
#include "datasets/support/input_error.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "tests/support/real_frames.h"
#include "tests/support/refused_threads.h"
#include "tests/support/tiny_frames.h"

namespace {

using namespace epcc;
using test::MemorySource;
using test::tinyFrame;

using Sources = std::vector<std::unique_ptr<FrameSource>>;

/// Finds the planes of the truth, or fails.
class OracleSegmenter : public PlaneSegmenter {
 public:
  OracleSegmenter(std::string failing_frame, SensorModel* seen)
      : failing_frame_(std::move(failing_frame)), seen_(seen) {}
  std::string name() const override { return "oracle"; }

 protected:
  bool run(const SegmenterInput& input, PlaneSegmentation& result) override {
    if (seen_ != nullptr) *seen_ = input.sensor;
    if (input.name == failing_frame_) return fail("no luck today");
    const LabelledFrame truth = tinyFrame("", 0);
    std::copy(truth.labels.data.begin(), truth.labels.data.end(), result.labels.begin());
    fitLabels(input, 3, result);
    return true;
  }

 private:
  std::string failing_frame_;
  SensorModel* seen_;
};

Method oracle(const std::string& failing_frame = "-", SensorModel* seen = nullptr) {
  return {"oracle", [=] { return std::make_unique<OracleSegmenter>(failing_frame, seen); }, true};
}

/// Another segmenter finishes the first frame only after another frame, so that they finish out of order.
class LateFirstFrame : public OracleSegmenter {
 public:
  explicit LateFirstFrame(std::atomic<bool>* another_done)
      : OracleSegmenter("-", nullptr), another_done_(another_done) {}

 protected:
  bool run(const SegmenterInput& input, PlaneSegmentation& result) override {
    if (input.name != "f0") *another_done_ = true;
    while (!*another_done_) std::this_thread::yield();
    return OracleSegmenter::run(input, result);
  }

 private:
  std::atomic<bool>* another_done_;
};

Sources oneSource(std::vector<LabelledFrame> frames) {
  Sources sources;
  sources.push_back(std::make_unique<MemorySource>("rooms", std::move(frames)));
  return sources;
}

std::vector<FrameRecord> run(const Sources& sources, const std::vector<Method>& methods,
                             const ExperimentOptions& options = {}) {
  std::vector<FrameRecord> all;
  runExperiment(listJobs(sources), methods, options, {}, [&](const std::vector<FrameRecord>& records) {
    all.insert(all.end(), records.begin(), records.end());
  });
  return all;
}

TEST(Experiment, PerfectSegmentationScoresN) {
  const auto records = run(oneSource({tinyFrame("f0", 1)}), {oracle()});
  ASSERT_EQ(records.size(), 1U);
  const FrameRecord& record = records[0];
  EXPECT_EQ(record.dataset + record.frame + record.method + record.error, "roomsf0oracle");
  EXPECT_EQ(record.measures.paper.surfaces, 3);
  EXPECT_EQ(record.measures.paper.detected, 3);
  EXPECT_EQ(record.measures.segcomp.correct, 3);
  EXPECT_DOUBLE_EQ(record.measures.instances.meanIou(), 1.0);
  EXPECT_EQ(record.measures.planes.planes, 3);
  EXPECT_LT(record.measures.planes.meanNormalDegrees(), 0.1);
  EXPECT_LT(record.measures.planes.meanOffsetMetres(), 0.002);
  EXPECT_GT(record.ms.value(), 0.0);
}

TEST(Experiment, EveryRegisteredMethodFindsTheRoom) {
  std::vector<Method> methods;
  for (const std::string& name : segmenterNames()) methods.push_back(registeredMethod(name));
  for (const FrameRecord& record : run(oneSource({tinyFrame("f0", 1)}), methods)) {
    EXPECT_EQ(record.error, "") << record.method;
    EXPECT_EQ(record.measures.paper.surfaces, 3) << record.method;
    EXPECT_GE(record.measures.paper.detected, 1) << record.method;
    EXPECT_GT(record.ms.value(), 0.0) << record.method;
  }
}

TEST(Experiment, UnknownMethodIsRefused) {
  EXPECT_THROW(registeredMethod("epc"), std::invalid_argument);
}

TEST(Experiment, AFailingMethodCostsOneRecord) {
  const auto records = run(oneSource({tinyFrame("f0", 1), tinyFrame("f1", 2)}), {oracle("f0"), oracle()});
  ASSERT_EQ(records.size(), 4U);
  EXPECT_EQ(records[0].error, "no luck today");
  EXPECT_FALSE(records[0].ms.has_value());
  EXPECT_EQ(records[0].measures.paper.surfaces, 0);
  for (const std::size_t i : {1U, 2U, 3U}) EXPECT_EQ(records[i].measures.segcomp.correct, 3) << i;
}

TEST(Experiment, AFrameThatCannotBeUsedCostsOneRecordAMethod) {
  LabelledFrame unlabelled = tinyFrame("f0", 1);
  unlabelled.labels = LabelImage();
  LabelledFrame odd_noise = tinyFrame("f1", 1);
  odd_noise.camera.noise = "no-such-sensor";
  const auto records = run(oneSource({unlabelled, odd_noise, tinyFrame("f2", 1)}), {oracle(), oracle()});
  ASSERT_EQ(records.size(), 6U);
  for (const std::size_t i : {0U, 1U}) EXPECT_NE(records[i].error.find("labels: "), std::string::npos) << i;
  for (const std::size_t i : {2U, 3U}) EXPECT_NE(records[i].error.find("noise: "), std::string::npos) << i;
  for (const std::size_t i : {4U, 5U}) EXPECT_EQ(records[i].error, "") << i;
}

TEST(Experiment, NoiseOfTheOptionsBeforeTheFramesBeforeTheMeasured) {
  SensorModel seen = *SensorModel::preset("kinect-v1");
  const SensorModel given = SensorModel::axial(0.01, 0.02, 3.0);
  run(oneSource({tinyFrame("f", 1)}), {oracle("-", &seen)}, {"0.01,0.02,3", 1});
  EXPECT_EQ(seen.description(), given.description());
  run(oneSource({tinyFrame("f", 1)}), {oracle("-", &seen)});
  EXPECT_EQ(seen.description(), SensorModel::axial(0.0005, 0.0005, 1.0).description());
  LabelledFrame plain = tinyFrame("f", 1);
  plain.camera.noise.reset();
  run(oneSource({plain}), {oracle("-", &seen)});
  const auto view = DepthFrame::fromDepth(plain.depth.data.data(), plain.camera.camera);
  EXPECT_EQ(seen.description(), estimateSensor(view).model().description());
}

TEST(Experiment, OrderDoesNotDependOnTheThreads) {
  std::vector<LabelledFrame> frames;
  for (unsigned i = 0; i < 8; ++i) frames.push_back(tinyFrame("f" + std::to_string(i), i));
  const Sources sources = oneSource(frames);
  for (const int jobs : {1, 2, 5, 30}) {
    std::atomic<bool> another_done{jobs == 1};
    const Method late = {"late", [&] { return std::make_unique<LateFirstFrame>(&another_done); }, true};
    const auto records = run(sources, {late, oracle("f3")}, {"", jobs});
    ASSERT_EQ(records.size(), 16U);
    for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(records[i].frame, "f" + std::to_string(i / 2)) << jobs;
    EXPECT_EQ(records[7].error, "no luck today");
  }
}

TEST(Experiment, WhatWritingThrowsEndsTheRun) {
  std::vector<LabelledFrame> frames(40, tinyFrame("f", 1));
  const Sources sources = oneSource(frames);
  for (const int jobs : {1, 3}) {
    std::atomic<int> calls{0};
    const auto full = [&](const FrameResult&) {
      ++calls;
      throw OutputError("disk", "space", "none left");
    };
    EXPECT_THROW(runExperiment(listJobs(sources), {oracle()}, {"", jobs}, full, {}), OutputError);
    EXPECT_LE(calls, jobs);
  }
}

TEST(Experiment, WithTooLittleMemoryToWriteAFrameItIsAnError) {
  const Sources sources = oneSource({tinyFrame("f0", 1), tinyFrame("f1", 2)});
  const auto large = [](const FrameResult& result) {
    if (result.index == 0 && !result.segmentations.empty()) throw std::bad_alloc();
  };
  std::string errors;
  runExperiment(listJobs(sources), {oracle()}, {}, large,
                [&](const std::vector<FrameRecord>& records) { errors += records[0].error + ";"; });
  EXPECT_EQ(errors, "needs more memory than there is;;");
}

TEST(Experiment, WhatMakingASegmenterThrowsEndsTheRun) {
  const Sources sources = oneSource(std::vector<LabelledFrame>(40, tinyFrame("f", 1)));
  const Method broken = {"broken", []() -> std::unique_ptr<PlaneSegmenter> { throw std::bad_alloc(); }, true};
  for (const int jobs : {1, 3}) EXPECT_THROW(run(sources, {broken}, {"", jobs}), std::bad_alloc) << jobs;
}

TEST(Experiment, WithoutThreadsTheRunIsTheSame) {
  const Sources sources = oneSource({tinyFrame("f0", 1), tinyFrame("f1", 2), tinyFrame("f2", 3)});
  EXPECT_TRUE(test::holdsWithoutThreads([&] {
    const auto records = run(sources, {oracle("f1")}, {"", 3});
    return records.size() == 3 && records[0].measures.segcomp.correct == 3 && records[1].error == "no luck today" &&
           records[2].measures.segcomp.correct == 3;
  }));
}

TEST(Experiment, ResultsCarryFrameAndLabelsForTheFiles) {
  const Sources sources = oneSource({tinyFrame("f", 1)});
  std::vector<FrameResult> results;
  runExperiment(listJobs(sources), {oracle(), oracle("f")}, {}, [&](const FrameResult& r) { results.push_back(r); },
                {});
  ASSERT_EQ(results.size(), 1U);
  ASSERT_EQ(results[0].segmentations.size(), 2U);
  EXPECT_EQ(results[0].segmentations[0].planes.size(), 3U);
  EXPECT_EQ(results[0].segmentations[1].planes.size(), 0U);
  EXPECT_EQ(results[0].frame.depth.data.size(), 4800U);
}

TEST(Experiment, FileNamesCarryTheDataSetOnlyWhereFramesShareAName) {
  Sources sources;
  sources.push_back(
      std::make_unique<MemorySource>("a", std::vector<LabelledFrame>{tinyFrame("x", 1), tinyFrame("y", 1)}));
  sources.push_back(std::make_unique<MemorySource>("b", std::vector<LabelledFrame>{tinyFrame("y", 1)}));
  const auto jobs = listJobs(sources);
  ASSERT_EQ(jobs.size(), 3U);
  EXPECT_EQ(jobs[0].file_name, "x");
  EXPECT_EQ(jobs[1].file_name, "a/y");
  EXPECT_EQ(jobs[2].file_name, "b/y");
}

TEST(Experiment, RealTruthAgainstItselfIsPerfect) {
  const std::pair<const char*, long> surfaces[] = {{"realsense", 29}, {"kinect", 80}, {"abw", 266}, {"icl", 17}};
  for (const auto& [name, count] : surfaces) {
    EPCC_NEED_REAL_FRAMES(name);
    const NativeFolder folder(test::realFolder(name));
    FrameMeasures sum;
    for (std::size_t i = 0; i < folder.size(); ++i) {
      const LabelledFrame frame = folder.read(i);
      PlaneSegmentation copy{frame.depth.width, frame.depth.height, {}, {}, {}, {}};
      for (const std::uint16_t label : frame.labels.data) copy.labels.push_back(label == kIgnoreLabel ? 0 : label);
      sum += measureFrame(frame, copy);
    }
    EXPECT_EQ(sum.paper.surfaces, count) << name;
    EXPECT_EQ(sum.paper.detected, count) << name;
    EXPECT_EQ(sum.segcomp.correct, count) << name;
    EXPECT_EQ(sum.segcomp.noise + sum.segcomp.missed + sum.paper.over_segmented, 0) << name;
  }
}

TEST(Experiment, NoJobsIsNoError) {
  EXPECT_TRUE(run({}, {oracle()}).empty());
}

}  // namespace
