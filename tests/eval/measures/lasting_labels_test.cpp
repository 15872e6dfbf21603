// SPDX-License-Identifier: BSD-3-Clause
// Lasting labels on views whose shared pixels are known: every pixel is its own partner.
#include "eval/measures/lasting_labels.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace epcc::test {
namespace {

constexpr int kWidth = 100, kHeight = 10;

/// Stripes of columns: label[k] from column start[k] on, all flat but those in `bent`.
LastingRegions stripes(const std::vector<std::pair<int, int>>& starts_and_labels, const std::vector<int>& bent = {}) {
  LastingRegions regions;
  regions.labels = LabelImage(kWidth, kHeight);
  for (int row = 0; row < kHeight; ++row)
    for (int column = 0; column < kWidth; ++column)
      for (const auto& [start, label] : starts_and_labels)
        if (column >= start) regions.labels.at(row, column) = static_cast<std::uint16_t>(label);
  for (const auto& entry : starts_and_labels) regions.flat[entry.second] = true;
  for (const int label : bent) regions.flat[label] = false;
  return regions;
}

std::vector<std::int32_t> itself() {
  std::vector<std::int32_t> shared(kWidth * kHeight);
  std::iota(shared.begin(), shared.end(), 0);
  return shared;
}

TEST(LastingRepeatability, NeedsTheSameLabel) {
  const LastingRepeatability same =
      lastingRepeatability(itself(), stripes({{0, 7}, {40, 3}}), stripes({{0, 7}, {40, 3}}));
  EXPECT_EQ(same.pairs, 1);
  EXPECT_EQ(same.shared, 1000);
  EXPECT_EQ(same.regions, 2);
  EXPECT_EQ(same.repeated, 2);
  EXPECT_EQ(same.repeated_pixels, 1000);
  const LastingRepeatability other =
      lastingRepeatability(itself(), stripes({{0, 7}, {40, 3}}), stripes({{0, 7}, {40, 4}}));
  EXPECT_EQ(other.repeated, 1);
  EXPECT_EQ(other.repeated_pixels, 400);
}

TEST(LastingRepeatability, ViewsMayBeginWithoutALabel) {
  const LastingRegions regions = stripes({{0, 0}, {60, 1}});
  const LastingRepeatability result = lastingRepeatability(itself(), regions, regions);
  EXPECT_EQ(result.regions, 1);
  EXPECT_EQ(result.repeated_pixels, 400);
}

TEST(LastingRepeatability, AddsUp) {
  const LastingRegions regions = stripes({{0, 7}, {40, 3}});
  LastingRepeatability sum = lastingRepeatability(itself(), regions, regions);
  sum += lastingRepeatability(itself(), regions, stripes({{0, 7}, {40, 4}}));
  EXPECT_EQ(sum.pairs, 2);
  EXPECT_EQ(sum.shared, 2000);
  EXPECT_EQ(sum.regions, 4);
  EXPECT_EQ(sum.repeated, 3);
  EXPECT_EQ(sum.repeated_pixels, 1400);
}

TEST(LastingRepeatability, SwappedLabelsAreNoRepetition) {
  EXPECT_EQ(lastingRepeatability(itself(), stripes({{0, 1}, {50, 2}}), stripes({{0, 2}, {50, 1}})).repeated, 0);
}

TEST(LastingRepeatability, KeepsTheRulesOfRepeatability) {
  EXPECT_EQ(lastingRepeatability(itself(), stripes({{0, 1}}), stripes({{0, 1}, {80, 2}})).repeated, 1);
  EXPECT_EQ(lastingRepeatability(itself(), stripes({{0, 1}}), stripes({{0, 1}, {79, 2}})).repeated, 0);
  EXPECT_EQ(lastingRepeatability(itself(), stripes({{0, 1}, {81, 2}}), stripes({{0, 1}, {81, 2}})).regions, 1);
  EXPECT_EQ(lastingRepeatability(itself(), stripes({{0, 1}}, {1}), stripes({{0, 1}})).regions, 0) << "not flat";
  EXPECT_EQ(lastingRepeatability(itself(), stripes({{0, 1}}), stripes({{0, 1}}, {1})).repeated, 0) << "not flat";
  std::vector<std::int32_t> few(kWidth * kHeight, -1);
  for (std::size_t i = 0; i < 199; ++i) few[i] = static_cast<std::int32_t>(i);
  EXPECT_EQ(lastingRepeatability(few, stripes({{0, 1}}), stripes({{0, 1}})).regions, 0);
}

TEST(LastingRegions, GivesPlanesTheirLabels) {
  SeenRegions regions;
  regions.labels = LabelImage(4, 1);
  regions.labels.data = {1, 2, 2, 3};
  regions.planes.resize(3);
  regions.flat = {false, true, false, true};
  const LastingRegions lasting = lastingRegions(regions, {9, 9, 0});
  EXPECT_EQ(lasting.labels.data, (std::vector<std::uint16_t>{9, 9, 9, 0}));
  EXPECT_EQ(lasting.flat, (std::map<int, bool>{{9, false}})) << "as its largest plane";
  EXPECT_THROW(lastingRegions(regions, {9}), std::invalid_argument);
}

TEST(SwitchCounter, CountsChangesOfTheHolder) {
  SwitchCounter counter;
  const LabelImage truth(kWidth, kHeight, 5);
  counter.add(truth, stripes({{0, 1}}).labels, 0.0);
  counter.add(truth, stripes({{0, 1}, {60, 2}}).labels, 1.0);  // 1 holds most
  counter.add(truth, stripes({{0, 1}, {40, 2}}).labels, 2.0);  // 2 does
  counter.add(truth, LabelImage(kWidth, kHeight), 3.0);        // nothing to tell
  counter.add(truth, stripes({{0, 2}}).labels, 4.0);           // still 2
  counter.add(truth, stripes({{0, 1}}).labels, 6.0);           // back
  EXPECT_EQ(counter.result().switches, 2);
  EXPECT_DOUBLE_EQ(counter.result().seconds, 6.0);
  EXPECT_DOUBLE_EQ(counter.result().perMinute(), 20.0);
}

TEST(SwitchCounter, StayingIsNoSwitch) {
  SwitchCounter counter;
  const LabelImage truth(kWidth, kHeight, 5);
  for (const double time : {0.0, 1.0, 2.0, 3.0}) counter.add(truth, stripes({{0, 1}}).labels, time);
  EXPECT_EQ(counter.result().switches, 0);
  EXPECT_DOUBLE_EQ(counter.result().seconds, 3.0);
}

TEST(SwitchCounter, LeavesOutWhatIsNoSurfaceOrSmall) {
  SwitchCounter counter;
  LabelImage truth(kWidth, kHeight, kIgnoreLabel);
  for (std::size_t i = 0; i < 199; ++i) truth.data[i] = 1;
  for (std::size_t i = 199; i < 600; ++i) truth.data[i] = 0;
  for (const int label : {1, 2, 3}) counter.add(truth, stripes({{0, label}}).labels, label);
  EXPECT_EQ(counter.result().switches, 0);
  EXPECT_EQ(counter.result().seconds, 0.0);
  EXPECT_EQ(counter.result().perMinute(), 0.0);
  EXPECT_THROW(counter.add(truth, LabelImage(3, 3), 4.0), std::invalid_argument);
}

TEST(LabelSwitches, WatchesTheFiveLargest) {
  const std::vector<std::pair<int, int>> from = {{0, 1}, {30, 2}, {50, 3}, {70, 4}, {90, 5}};
  const LabelSwitches all = labelSwitches(itself(), stripes(from), stripes(from), 1.5);
  EXPECT_EQ(all.switches, 0);
  EXPECT_DOUBLE_EQ(all.seconds, 6.0) << "the last has 100 pixels";
  const LabelSwitches changed =
      labelSwitches(itself(), stripes(from), stripes({{0, 8}, {30, 2}, {50, 0}, {70, 4}, {75, 9}}), 1.5);
  EXPECT_EQ(changed.switches, 2) << "1 to 8 and 4 to 9; 3 has no label there";
  EXPECT_DOUBLE_EQ(changed.seconds, 4.5);
}

TEST(SquaredErrors, OfAFewValues) {
  SquaredErrors errors;
  EXPECT_EQ(errors.mean(), 0.0);
  EXPECT_EQ(errors.shareWithinLimit(), 0.0);
  for (const double value : {1.0, 3.0, 7.8, 7.9, 100.0, -1.0}) errors.add(value);
  EXPECT_EQ(errors.size(), 5) << "a negative one is none";
  EXPECT_DOUBLE_EQ(errors.mean(), 23.94);
  EXPECT_DOUBLE_EQ(errors.median(), 7.8);
  EXPECT_DOUBLE_EQ(errors.shareWithinLimit(), 0.6);
}

}  // namespace
}  // namespace epcc::test
