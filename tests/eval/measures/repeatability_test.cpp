// SPDX-License-Identifier: BSD-3-Clause
// Repeatability on views whose shared pixels, regions and planes are known exactly.
#include "eval/measures/repeatability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/eval/measures/posed_room.h"

namespace epcc::test {
namespace {

const SensorModel kCentimetre = SensorModel::axial(0.01, 0.0);

PinholeCamera smallCamera(int width = 100, int height = 10) {
  return {width, height, 100.0, 100.0, 0.5 * (width - 1), 0.5 * (height - 1)};
}

/// A wall straight ahead that fills the view.
PosedView wallView(float distance = 2.0F, const PinholeCamera& camera = smallCamera()) {
  PosedView view;
  view.camera = camera;
  view.depth = DepthImage(camera.width, camera.height, distance);
  return view;
}

Plane wallPlane(double distance = 2.0) {
  Plane plane;
  plane.coefficients << 0.0, 0.0, -1.0, distance;
  plane.centroid << 0.0, 0.0, distance;
  return plane;
}

/// The wall in vertical stripes: label k + 1 from column starts[k] on, each with the wall's plane.
PlaneSegmentation striped(const PosedView& view, const std::vector<int>& starts) {
  PlaneSegmentation segmentation;
  segmentation.width = view.depth.width;
  segmentation.height = view.depth.height;
  segmentation.planes.assign(starts.size(), wallPlane());
  for (int row = 0; row < segmentation.height; ++row)
    for (int column = 0; column < segmentation.width; ++column) {
      std::int32_t label = 0;
      for (const int start : starts) label += column >= start ? 1 : 0;
      segmentation.labels.push_back(label);
    }
  return segmentation;
}

Repeatability ofStripes(const std::vector<int>& from, const std::vector<int>& to) {
  const PosedView view = wallView();
  return repeatability(view, seenRegions(view, striped(view, from), kCentimetre), view,
                       seenRegions(view, striped(view, to), kCentimetre));
}

TEST(Repeatability, AnIdenticalPairIsRepeatedAsAWhole) {
  const Repeatability result = ofStripes({0, 30, 70}, {0, 30, 70});
  EXPECT_EQ(result.pairs, 1);
  EXPECT_EQ(result.shared, 1000);
  EXPECT_EQ(result.labelled, 1000);
  EXPECT_EQ(result.repeated_pixels, 1000);
  EXPECT_EQ(result.regions, 3);
  EXPECT_EQ(result.repeated, 3);
  EXPECT_EQ(result.millidegrees.median(), 0.0);
  EXPECT_EQ(result.micrometres.median(), 0.0);
}

TEST(Repeatability, ARegionCutInTwoIsNotRepeatedEitherWay) {
  const Repeatability cut = ofStripes({0}, {0, 50}), joined = ofStripes({0, 50}, {0});
  EXPECT_EQ(cut.regions, 1);
  EXPECT_EQ(joined.regions, 2);
  for (const Repeatability* result : {&cut, &joined}) {
    EXPECT_EQ(result->repeated, 0);
    EXPECT_EQ(result->repeated_pixels, 0);
    EXPECT_EQ(result->labelled, 1000);
    EXPECT_FALSE(result->millidegrees.median().has_value());
  }
}

TEST(Repeatability, RegionsMayBeInterleaved) {
  const PosedView view = wallView();
  PlaneSegmentation combed = striped(view, {0, 50});
  for (std::size_t i = 0; i < combed.labels.size(); ++i) combed.labels[i] = 1 + static_cast<std::int32_t>(i % 2);
  const SeenRegions regions = seenRegions(view, combed, kCentimetre);
  const Repeatability result = repeatability(view, regions, view, regions);
  EXPECT_EQ(result.repeated, 2);
  EXPECT_EQ(result.repeated_pixels, 1000);
}

TEST(Repeatability, EightyPercentOfBothPartnersSuffice) {
  EXPECT_EQ(ofStripes({0}, {0, 80}).repeated, 1);
  EXPECT_EQ(ofStripes({0}, {0, 80}).repeated_pixels, 1000) << "all shared pixels of the repeated region";
  EXPECT_EQ(ofStripes({0}, {0, 79}).repeated, 0);
  EXPECT_EQ(ofStripes({0, 80}, {0}).repeated, 1);
  EXPECT_EQ(ofStripes({0, 79}, {0}).repeated, 0);
}

TEST(Repeatability, UnlabelledPixelsCountAsSharedNotAsLabelled) {
  const Repeatability result = ofStripes({40}, {0});
  EXPECT_EQ(result.shared, 1000);
  EXPECT_EQ(result.labelled, 600);
  EXPECT_EQ(result.repeated, 0) << "the partner shares 600 of its 1000 pixels";
}

TEST(Repeatability, RegionsNeedTwoHundredSharedPixels) {
  EXPECT_EQ(ofStripes({0, 80}, {0, 80}).regions, 2);
  EXPECT_EQ(ofStripes({0, 81}, {0, 81}).regions, 1);
}

/// Two walls that meet in the middle of the view, with one label and a plane through both.
TEST(Repeatability, LabellingEverythingAlikeWinsNothing) {
  PosedView view = wallView();
  for (int row = 0; row < view.depth.height; ++row)
    for (int column = 0; column < view.depth.width; ++column)
      view.depth.at(row, column) = 2.0F + 0.01F * static_cast<float>(std::abs(column - 50));
  PlaneSegmentation alike = striped(view, {0});
  alike.planes[0] = wallPlane(2.25);
  const SeenRegions regions = seenRegions(view, alike, kCentimetre);
  EXPECT_FALSE(regions.flat[1]);
  const Repeatability result = repeatability(view, regions, view, regions);
  EXPECT_EQ(result.labelled, 1000);
  EXPECT_EQ(result.regions, 0);
  EXPECT_EQ(result.repeated, 0);
  EXPECT_EQ(result.repeated_pixels, 0);
}

TEST(Repeatability, EightyFivePercentWithinThreeSigmaAreFlat) {
  for (const int off : {15, 16}) {
    PosedView view = wallView();
    for (int row = 0; row < view.depth.height; ++row)
      for (int column = 0; column < off; ++column) view.depth.at(row, column) = 2.031F;
    EXPECT_EQ(seenRegions(view, striped(view, {0}), kCentimetre).flat[1], off == 15) << off;
    EXPECT_TRUE(seenRegions(view, striped(view, {0}), SensorModel::axial(0.011, 0.0)).flat[1]) << "31 mm are within 33";
  }
}

TEST(Repeatability, APartnerThatIsNotFlatDoesNotCount) {
  const PosedView view = wallView();
  PlaneSegmentation bad = striped(view, {0});
  bad.planes[0] = wallPlane(2.2);
  const SeenRegions good_regions = seenRegions(view, striped(view, {0}), kCentimetre);
  const SeenRegions bad_regions = seenRegions(view, bad, kCentimetre);
  EXPECT_EQ(repeatability(view, good_regions, view, bad_regions).repeated, 0);
  EXPECT_EQ(repeatability(view, good_regions, view, bad_regions).regions, 1);
  EXPECT_EQ(repeatability(view, bad_regions, view, good_regions).regions, 0);
}

TEST(Repeatability, PixelsBehindAnOccluderDoNotCount) {
  const PosedView from = wallView();
  PosedView to = wallView();
  for (int row = 0; row < to.depth.height; ++row)
    for (int column = 0; column < 30; ++column) to.depth.at(row, column) = 1.0F;
  const std::vector<std::int32_t> shared = sharedPixels(from, to);
  for (std::size_t i = 0; i < shared.size(); ++i)
    EXPECT_EQ(shared[i], i % 100 < 30 ? -1 : static_cast<std::int32_t>(i));
  const Repeatability result = repeatability(from, seenRegions(from, striped(from, {0}), kCentimetre), to,
                                             seenRegions(to, striped(to, {30}), kCentimetre));
  EXPECT_EQ(result.shared, 700);
  EXPECT_EQ(result.repeated_pixels, 700);
}

TEST(Repeatability, DepthsAgreeWithinTwoCentimetresAndTwoPercent) {
  const PosedView from = wallView();  // 6 cm at 2 m
  for (const float depth : {1.941F, 2.059F}) EXPECT_EQ(sharedPixels(from, wallView(depth))[0], 0) << depth;
  const float none = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  for (const float depth : {1.939F, 2.061F, 0.0F, -2.0F, none, infinite}) {
    EXPECT_EQ(sharedPixels(from, wallView(depth))[0], -1) << depth;
    if (!(depth > 1.0F && depth < 3.0F)) {
      EXPECT_EQ(sharedPixels(wallView(depth), from)[0], -1) << depth;
    }
  }
}

/// One pixel of the wall is 2 cm wide: a camera 20 cm further right sees it ten columns further left.
TEST(Repeatability, PixelsAreCarriedByThePose) {
  const PosedView from = wallView();
  PosedView to = wallView();
  to.pose.translation().x() = 0.2;
  const std::vector<std::int32_t> shared = sharedPixels(from, to);
  for (std::size_t i = 0; i < shared.size(); ++i)
    EXPECT_EQ(shared[i], i % 100 < 10 ? -1 : static_cast<std::int32_t>(i) - 10);
  to = wallView(1.5F);
  to.pose.translation().z() = 0.5;
  EXPECT_EQ(sharedPixels(from, to)[0], -1) << "the border leaves the view of a camera that is nearer";
  EXPECT_EQ(sharedPixels(from, to)[550], 550);
  to.pose.translation().z() = 2.5;
  EXPECT_EQ(sharedPixels(from, to)[550], -1) << "behind the camera";
}

TEST(Repeatability, AnglesAndOffsetsAreThoseOfThePartnersPlanes) {
  const PosedView view = wallView();
  PlaneSegmentation turned = striped(view, {0});
  const double angle = 0.5 * M_PI / 180.0;
  turned.planes[0].coefficients << std::sin(angle), 0.0, -std::cos(angle), 2.005 * std::cos(angle);
  const Repeatability result = repeatability(view, seenRegions(view, striped(view, {0}), kCentimetre), view,
                                             seenRegions(view, turned, kCentimetre));
  ASSERT_EQ(result.repeated, 1);
  EXPECT_EQ(result.millidegrees.median(), 500.0);
  EXPECT_EQ(result.micrometres.median(), 5000.0);
}

TEST(Repeatability, SumsAddUp) {
  Repeatability sum = ofStripes({0, 30, 70}, {0, 30, 70});
  sum += ofStripes({0}, {0, 50});
  EXPECT_EQ(sum.pairs, 2);
  EXPECT_EQ(sum.shared, 2000);
  EXPECT_EQ(sum.labelled, 2000);
  EXPECT_EQ(sum.repeated_pixels, 1000);
  EXPECT_EQ(sum.regions, 4);
  EXPECT_EQ(sum.repeated, 3);
  EXPECT_EQ(sum.millidegrees.size(), 3);
}

TEST(Repeatability, OtherSizesAreRefused) {
  const PosedView view = wallView();
  EXPECT_THROW(seenRegions(view, PlaneSegmentation(), kCentimetre), std::invalid_argument);
  EXPECT_THROW(seenRegions(view, striped(wallView(2.0F, smallCamera(50, 20)), {0}), kCentimetre),
               std::invalid_argument);
}

TEST(ValueCounts, MedianOfEvenAndOddNumbers) {
  ValueCounts values;
  EXPECT_FALSE(values.median().has_value());
  for (const long value : {7L, 1L, 7L}) values.add(value);
  EXPECT_EQ(values.median(), 7.0);
  values.add(2);
  EXPECT_EQ(values.median(), 4.5);
}

SeenRegions segmented(const PosedView& view) {
  const SensorModel sensor = *SensorModel::preset("rendered");
  PlaneExtractor extractor(Parameters(), sensor);
  PlaneSegmentation segmentation;
  EXPECT_TRUE(extractor.extract(DepthFrame::fromDepth(view.depth.data.data(), view.camera), segmentation));
  return seenRegions(view, segmentation, SensorModel::axial(0.001, 0.0));
}

TEST(Repeatability, TwoRenderedViewsOfARoomAgree) {
  const PosedView first = viewFrom({{0.0, 0.0, 1.4}, 0.0, 0.25, 0.0});
  PosedView second = viewFrom({{-0.3, 0.2, 1.5}, -0.12, 0.3, 0.05});
  const SeenRegions from = segmented(first), to = segmented(second);
  const Repeatability result = repeatability(first, from, second, to);
  EXPECT_GT(result.shared, 40000);
  EXPECT_EQ(result.regions, 5);
  EXPECT_EQ(result.repeated, 5);
  EXPECT_GT(result.repeated_pixels, result.shared * 97 / 100);
  EXPECT_LT(result.millidegrees.median(), 20.0);
  EXPECT_LT(result.micrometres.median(), 500.0);

  second.pose = first.pose;
  const Repeatability misplaced = repeatability(first, from, second, to);
  EXPECT_LT(misplaced.repeated, 5);
  EXPECT_LT(misplaced.repeated_pixels, result.repeated_pixels / 2);
}

}  // namespace
}  // namespace epcc::test
