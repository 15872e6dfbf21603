// SPDX-License-Identifier: BSD-3-Clause
// Sequences through methods: which frames are paired, with which sensor, and what becomes of frames with problems.
#include "eval/experiment/sequence_repeatability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>

#include "datasets/files/frame_pose.h"
#include "eval/report/repeatability_table.h"
#include "tests/support/tiny_frames.h"

namespace epcc::test {
namespace {

/// The corner's true planes, but for the frames named, which fail.
class TruthSegmenter : public PlaneSegmenter {
 public:
  explicit TruthSegmenter(std::string failing_frame) : failing_frame_(std::move(failing_frame)) {}
  std::string name() const override { return "truth"; }

 protected:
  bool run(const SegmenterInput& input, PlaneSegmentation& result) override {
    if (input.name == failing_frame_) return fail("no luck today");
    const LabelledFrame truth = tinyFrame("", 0);
    std::copy(truth.labels.data.begin(), truth.labels.data.end(), result.labels.begin());
    fitLabels(input, 3, result);
    return true;
  }

 private:
  std::string failing_frame_;
};

Method truth(const std::string& name, const std::string& failing_frame = "-") {
  return {name, [=] { return std::make_unique<TruthSegmenter>(failing_frame); }, true};
}

LabelledFrame posedFrame(int number) {
  LabelledFrame frame = tinyFrame("f" + std::to_string(number), static_cast<unsigned>(number));
  setFramePose(Eigen::Isometry3d::Identity(), frame);
  frame.labels = LabelImage();
  return frame;
}

std::vector<LabelledFrame> posedFrames(int count) {
  std::vector<LabelledFrame> frames;
  for (int i = 0; i < count; ++i) frames.push_back(posedFrame(i));
  return frames;
}

SequenceResult measured(const std::vector<LabelledFrame>& frames, const std::vector<Method>& methods,
                        const std::vector<int>& lags) {
  std::vector<std::unique_ptr<FrameSource>> sources;
  sources.push_back(std::make_unique<MemorySource>("walk", frames));
  return measureSequences(listJobs(sources), methods, {"", lags});
}

long pairsOf(const SequenceResult& result, std::size_t row) {
  return result.rows.at(row).sums.pairs;
}

TEST(SequenceRepeatability, EveryPairAtEveryLagCountsOnce) {
  const SequenceResult result = measured(posedFrames(6), {truth("one"), truth("two")}, {1, 4, 9});
  EXPECT_TRUE(result.problems.empty());
  ASSERT_EQ(result.rows.size(), 6U);
  for (std::size_t method = 0; method < 2; ++method) {
    EXPECT_EQ(result.rows[3 * method].method, method == 0 ? "one" : "two");
    EXPECT_EQ(result.rows[3 * method + 1].lag, 4);
    EXPECT_EQ(pairsOf(result, 3 * method), 5);
    EXPECT_EQ(pairsOf(result, 3 * method + 1), 2);
    EXPECT_EQ(pairsOf(result, 3 * method + 2), 0);
  }
  const Repeatability& sums = result.rows[0].sums;
  EXPECT_EQ(sums.shared, 5 * 80 * 60);
  EXPECT_EQ(sums.repeated_pixels, sums.shared) << "the same labels each time";
  EXPECT_EQ(sums.repeated, 15);
  EXPECT_LT(sums.millidegrees.median(), 200.0);
}

TEST(SequenceRepeatability, FramesWithProblemsKeepTheirPlaces) {
  std::vector<LabelledFrame> frames = posedFrames(6);
  frames[2].camera.extra.erase("pose");
  frames[3].scan.assign(3U * 80U * 60U, 1.0F);
  const SequenceResult result = measured(frames, {truth("one"), truth("two", "f5")}, {1, 2});
  ASSERT_EQ(result.problems.size(), 3U);
  EXPECT_EQ(result.problems[0], "f2.json: pose: is missing");
  EXPECT_NE(result.problems[1].find("f3"), std::string::npos);
  EXPECT_EQ(result.problems[2], "f5: two: no luck today");
  EXPECT_EQ(pairsOf(result, 0), 2) << "0-1, 4-5";
  EXPECT_EQ(pairsOf(result, 1), 0);
  EXPECT_EQ(pairsOf(result, 2), 1) << "0-1";
}

TEST(SequenceRepeatability, SequencesAreNotMixed) {
  std::vector<std::unique_ptr<FrameSource>> sources;
  for (const char* name : {"walk", "stroll"}) sources.push_back(std::make_unique<MemorySource>(name, posedFrames(3)));
  const SequenceResult result = measureSequences(listJobs(sources), {truth("one")}, {"", {1}});
  ASSERT_EQ(result.rows.size(), 2U);
  EXPECT_EQ(result.rows[1].dataset, "stroll");
  EXPECT_EQ(pairsOf(result, 0), 2);
  EXPECT_EQ(pairsOf(result, 1), 2);
}

/// With an error a tenth of the frames' the corner's faces are not flat any more.
TEST(SequenceRepeatability, FlatnessIsJudgedWithTheSensorModelGiven) {
  std::vector<LabelledFrame> frames = posedFrames(2);
  EXPECT_EQ(measured(frames, {truth("one")}, {1}).rows[0].sums.regions, 3);
  for (LabelledFrame& frame : frames) frame.camera.noise = "0.00005,0.00005,1";
  EXPECT_EQ(measured(frames, {truth("one")}, {1}).rows[0].sums.regions, 0);
}

/// Notes which frames are read.
class CountedReads : public MemorySource {
 public:
  using MemorySource::MemorySource;
  LabelledFrame read(std::size_t index) const override {
    reads_.insert(index);
    return MemorySource::read(index);
  }
  const std::multiset<std::size_t>& reads() const { return reads_; }

 private:
  mutable std::multiset<std::size_t> reads_;
};

TEST(SequenceRepeatability, EachFrameIsReadOnce) {
  std::vector<std::unique_ptr<FrameSource>> sources;
  sources.push_back(std::make_unique<CountedReads>("walk", posedFrames(5)));
  measureSequences(listJobs(sources), {truth("one"), truth("two")}, {"", {1, 2}});
  EXPECT_EQ(static_cast<const CountedReads&>(*sources[0]).reads(), (std::multiset<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(RepeatabilityTable, SharesCountsAndMedians) {
  RepeatabilityRow row{"walk", "epcc", 5, {}};
  row.sums.pairs = 2;
  row.sums.shared = 200;
  row.sums.labelled = 190;
  row.sums.repeated_pixels = 151;
  row.sums.regions = 8;
  row.sums.repeated = 7;
  row.sums.millidegrees.add(1234);
  row.sums.micrometres.add(4560);
  const Table table = repeatabilityTable({row, {"walk", "omps", 5, {}}});
  EXPECT_EQ(table.rows.at(0),
            (std::vector<std::string>{"walk", "epcc", "5", "2", "0.76", "0.95", "7 of 8", "1.23", "4.6"}));
  EXPECT_EQ(table.rows.at(1), (std::vector<std::string>{"walk", "omps", "5", "0", "-", "-", "0 of 0", "-", "-"}));
  EXPECT_NE(csvTable(repeatabilityCounts({row})).find("walk,epcc,5,2,200,190,151,8,7,1.234,4.560"), std::string::npos);
}

}  // namespace
}  // namespace epcc::test
