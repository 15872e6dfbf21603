// SPDX-License-Identifier: BSD-3-Clause
// Which pixels of a frame are measured, and how frames are sorted.
#include "eval/measures/frame_measures.h"

#include <gtest/gtest.h>

#include <limits>

#include "eval/measures/frame_score.h"
#include "eval/measures/measure_fields.h"

namespace epcc::test {
namespace {

TEST(FrameMeasures, PixelsWithoutDepthCountForNothing) {
  LabelledFrame frame;
  frame.depth = DepthImage(8, 1);
  frame.depth.data = {
      1.0F, 2.0F, 3.0F, 0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
      4.0F};
  frame.labels = LabelImage(8, 1, 1);
  PlaneSegmentation planes;
  planes.width = 8;
  planes.height = 1;
  planes.labels.assign(8, 1);
  const OverlapTable table = overlapTable(frame, planes);
  ASSERT_EQ(table.surfaceCount(), 1U);
  EXPECT_EQ(table.surfaceSize(1), 4);
  EXPECT_EQ(table.overlap(1, 1), 4);
}

TEST(FrameMeasures, OfSeveralFramesAddUp) {
  LabelledFrame frame;
  frame.depth = DepthImage(10, 1, 1.0F);
  frame.labels = LabelImage(10, 1, 3);
  PlaneSegmentation planes;
  planes.width = 10;
  planes.height = 1;
  planes.labels.assign(10, 1);
  planes.planes.resize(1);
  FrameMeasures sum = measureFrame(frame, planes);
  EXPECT_EQ(sum.paper.detected, 1);
  sum += sum;
  EXPECT_EQ(sum.paper.surfaces, 2);
  EXPECT_EQ(sum.segcomp.correct, 2);
  EXPECT_EQ(sum.instances.plane_pixels, 20);
}

TEST(MeasureFields, EachIsANumberOfItsOwn) {
  FrameMeasures measures;
  long number = 0;
  for (const auto* fields : {&countFields(), &furtherFields()})
    for (const MeasureField& field : *fields) field.of(measures) = ++number;
  EXPECT_EQ(number, 18);
  number = 0;
  for (const auto* fields : {&countFields(), &furtherFields()})
    for (const MeasureField& field : *fields) EXPECT_EQ(field.value(measures), ++number) << field.name;
}

FrameScore score(long correct, long surfaces, long clusters) {
  FrameMeasures measures;
  measures.segcomp.correct = correct;
  measures.paper.surfaces = surfaces;
  measures.paper.clusters = clusters;
  return FrameScore(measures);
}

TEST(FrameScore, SortsByTheShareThatIsCorrect) {
  EXPECT_TRUE(score(1, 2, 2) < score(2, 3, 3)) << "a half, two thirds";
  EXPECT_FALSE(score(2, 3, 3) < score(1, 2, 2));
  EXPECT_FALSE(score(1, 2, 2) < score(2, 4, 4));
  EXPECT_TRUE(score(2, 3, 3).reversed() < score(1, 2, 2).reversed());
}

TEST(FrameScore, NothingWhereThereIsNothingIsPerfect) {
  EXPECT_FALSE(score(0, 0, 0) < score(3, 3, 3));
  EXPECT_FALSE(score(3, 3, 3) < score(0, 0, 0));
  EXPECT_TRUE(score(0, 0, 1) < score(0, 0, 0)) << "something where there is nothing";
  EXPECT_TRUE(score(0, 1, 0) < score(0, 0, 0));
}

}  // namespace
}  // namespace epcc::test
