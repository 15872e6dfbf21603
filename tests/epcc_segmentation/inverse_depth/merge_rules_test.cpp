// SPDX-License-Identifier: BSD-3-Clause
// Single rules of what is joined: each test fails if one comparison is turned round (scripts/mutation_check.py).
#include <gtest/gtest.h>

#include <algorithm>

#include "inverse_depth/direction_joining.h"
#include "inverse_depth/plane_growing.h"
#include "inverse_depth/region_contacts.h"
#include "inverse_depth/region_merging.h"
#include "tests/epcc_segmentation/inverse_depth/region_fixture.h"

namespace {

using epcc::Contact;
using epcc::InverseDepthImage;
using epcc::RegionMap;
using epcc::RegionPair;
using epcc::test::imageOf;
using epcc::test::kWhite;
using epcc::test::regionsOf;
using epcc::test::RenderedRoom;

/// A wall two metres ahead; `change` may give a pixel another depth, and gives its label.
template <typename Change>
RenderedRoom changedWall(int width, int height, const Change& change) {
  RenderedRoom room{epcc::test::testCamera(width, height), {}, {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      float depth = 2.0f;
      room.labels.push_back(change(row, column, depth));
      room.depth.push_back(depth);
    }
  return room;
}

// ---- S2 and S3 ----

TEST(MergeRules, PlanesOfOneSizeAreNumberedInTheirOrder) {
  // Two walls side by side, each half of the image, seen by the columns and by the rows.
  const auto room = changedWall(100, 60, [](int, int column, float& depth) {
    depth = column < 50 ? 2.0f : 3.0f;
    return 0;
  });
  const auto image = imageOf(room);
  const epcc::InverseDepthParameters parameters;
  std::array<epcc::DirectionalPlanes, 2> directions{epcc::DirectionalPlanes(true, parameters, kWhite),
                                                    epcc::DirectionalPlanes(false, parameters, kWhite)};
  epcc::StripMemory memory;
  memory.growing.configure(parameters);
  for (epcc::DirectionalPlanes& direction : directions) {
    direction.setActive(true);
    direction.beginLines(image, parameters);
    for (int strip = 0; strip < direction.strips(); ++strip) direction.growStrip(image, strip, memory);
    direction.growPlanes(image);
    ASSERT_EQ(direction.planePoints(), (std::vector<double>{3000.0, 3000.0}));
  }
  RegionMap map;
  epcc::DirectionJoining joining;
  joining.join(image, directions, 1, map);
  EXPECT_EQ(map.labels[image.index(30, 20)], 1);
  EXPECT_EQ(map.labels[image.index(30, 80)], 2);
}

// ---- contacts ----

TEST(MergeRules, ContactsAddUp) {
  Contact first, second, both;
  first.add(1.0, 0.1, 0.2, 1.0);
  second.add(2.0, -0.3, 0.4, 1.0);
  second.add(0.5, 0.6, -0.1, 1.0);
  for (const auto& [weight, x, y] : {std::tuple{1.0, 0.1, 0.2}, {2.0, -0.3, 0.4}, {0.5, 0.6, -0.1}})
    both.add(weight, x, y, 1.0);
  first += second;
  EXPECT_EQ(first.count, 3);
  const Eigen::Vector3d q(0.3, -0.2, 0.7);
  EXPECT_DOUBLE_EQ(first.squares(q), both.squares(q));
}

constexpr int kRoundColumns = 40, kRoundRows = 4, kBridge = 5;

/// Places where region 1, at the beginning of each row of a full turn, meets region 2 at its end. So many pixels there
/// have no label: `before` in front of region 1, `behind` after region 2, all of them `depth` metres away.
int placesRound(int before, int behind, float depth = 2.0f, std::int32_t last_label = 2, bool closes_round = true) {
  const auto room = changedWall(kRoundColumns, kRoundRows, [&](int, int column, float& z) {
    if (column < before || column >= kRoundColumns - behind) {
      z = depth;
      return 0;
    }
    return column < 12 ? 1 : column >= 28 ? static_cast<int>(last_label) : 0;
  });
  InverseDepthImage image = imageOf(room);
  image.closes_round = closes_round;
  const RegionMap map = regionsOf(image, room.labels, 2);
  std::vector<epcc::ContactSearchMemory> memory;
  epcc::RegionContacts contacts;
  epcc::findContacts(image, kBridge, 3.0, map, memory, contacts);
  const Contact* contact = contacts.find({1, 2});
  return contact == nullptr ? 0 : contact->count;
}

TEST(MergeRules, TheEndsOfAFullTurnMeet) {
  EXPECT_EQ(placesRound(0, 0), kRoundRows);
  EXPECT_EQ(placesRound(0, 0, 2.0f, 2, false), 0) << "the view does not close";
  EXPECT_EQ(placesRound(0, 0, 2.0f, 1), 0) << "one region";
  EXPECT_EQ(placesRound(0, 0, 2.0f, 0), 0) << "no region at the end";
}

TEST(MergeRules, AcrossAsManyPixelsAsAreBridgedElsewhere) {
  for (const auto& [before, behind] : {std::pair{5, 0}, {0, 5}, {3, 2}}) {
    EXPECT_EQ(placesRound(before, behind), kRoundRows) << before << " " << behind;
    EXPECT_EQ(placesRound(before + 1, behind), 0) << before << " " << behind;
    EXPECT_EQ(placesRound(before, behind + 1), 0) << before << " " << behind;
    EXPECT_EQ(placesRound(before, behind, 3.0f), 0) << "a groove";
    EXPECT_EQ(placesRound(before, behind, 1.0f), kRoundRows) << "a ridge";
    EXPECT_EQ(placesRound(before, behind, 0.0f), kRoundRows) << "a hole";
  }
}

/// Places where the two regions of a view 160 pixels wide and 120 high face each other across an occluder.
template <typename Change>
int placesBehind(const Change& change) {
  const auto room = changedWall(160, 120, change);
  const auto image = imageOf(room);
  const RegionMap map = regionsOf(image, room.labels, 2);
  epcc::OcclusionMemory memory;
  epcc::RegionContacts contacts;
  epcc::findOccludedContacts(image, kBridge, 0.5, 3.0, map, memory, contacts);
  const Contact* contact = contacts.find({1, 2});
  return contact == nullptr ? 0 : contact->count;
}

TEST(MergeRules, PartsAboveAndBelowABarFaceEachOther) {
  const auto bar = [](int row, int, float& depth) {
    if (row < 50) return 1;
    if (row >= 70) return 2;
    depth = 1.0f;
    return 0;
  };
  EXPECT_EQ(placesBehind(bar), 80) << "every other column";
}

TEST(MergeRules, WhatIsBridgedIsNoOccluder) {
  // A pole in front of a wall, as wide as these say of its upper and of its lower half.
  const auto pole = [](int above, int below) {
    return [=](int row, int column, float& depth) {
      if (column < 70) return 1;
      if (column >= 70 + (row < 60 ? above : below)) return 2;
      depth = 1.0f;
      return 0;
    };
  };
  EXPECT_EQ(placesBehind(pole(kBridge + 1, kBridge + 1)), 60) << "every other row";
  EXPECT_EQ(placesBehind(pole(kBridge, kBridge)), 0);
  EXPECT_EQ(placesBehind(pole(kBridge + 1, kBridge)), 60) << "all of an occluder, if it is one";
}

// The blotches of a step as large as they are: the border's pixels lie in front of the other plane, those behind them
// do not. S8 took that for an occluder, and joined doors with their walls.
TEST(MergeRules, TheBorderOfANeighbourIsNoOccluder) {
  const auto step = [](int, int column, float& depth) {
    if (column < 80) return 1;
    depth -= column < 83 ? 0.05f : 0.001f;
    return 2;
  };
  EXPECT_EQ(placesBehind(step), 0);
}

// ---- S4 ----

struct KnownPairs {
  std::vector<RegionPair> alike, apart;
  std::vector<std::int32_t> labels;
};

/// What becomes of two halves of a view, of which so many are known, the second so many metres behind the first.
KnownPairs mergedHalves(int known, float behind) {
  const auto room = changedWall(160, 120, [&](int, int column, float& depth) {
    if (column >= 80) depth += behind;
    return column < 80 ? 1 : 2;
  });
  const auto image = imageOf(room);
  RegionMap map = regionsOf(image, room.labels, 2);
  map.known = known;
  std::vector<epcc::ContactSearchMemory> memory;
  epcc::RegionContacts contacts;
  epcc::findContacts(image, 25, 3.0, map, memory, contacts);
  epcc::RegionMerger merger;
  merger.merge(contacts, epcc::InverseDepthParameters(), kWhite, map);
  return {merger.alikeKnown(), merger.apartKnown(), {map.labels.front(), map.labels.back()}};
}

TEST(MergeRules, KnownRegionsAreToldToBeAlikeOrApartAndStayAsTheyAre) {
  const KnownPairs alike = mergedHalves(2, 0.0f);
  EXPECT_EQ(alike.labels, (std::vector<std::int32_t>{1, 2}));
  ASSERT_EQ(alike.alike.size(), 1U);
  EXPECT_EQ(alike.alike[0].low, 1);
  EXPECT_EQ(alike.alike[0].high, 2);
  EXPECT_TRUE(alike.apart.empty());
  const KnownPairs apart = mergedHalves(2, 0.5f);
  EXPECT_EQ(apart.labels, (std::vector<std::int32_t>{1, 2}));
  EXPECT_TRUE(apart.alike.empty());
  ASSERT_EQ(apart.apart.size(), 1U);
  EXPECT_EQ(apart.apart[0].low, 1);
}

TEST(MergeRules, ARegionThatIsNotKnownJoinsOneThatIs) {
  for (const int known : {0, 1}) {
    const KnownPairs merged = mergedHalves(known, 0.0f);
    EXPECT_EQ(merged.labels, (std::vector<std::int32_t>{1, 1})) << known;
    EXPECT_TRUE(merged.alike.empty() && merged.apart.empty()) << known;
  }
}

/// The labels 1, 2 and 3 of a view after S4, in their order.
std::vector<std::int32_t> mergedLabels(const RenderedRoom& room, const epcc::InverseDepthParameters& parameters,
                                       double correlated_share = 1.0) {
  const auto image = imageOf(room);
  const auto labels = static_cast<std::int32_t>(*std::max_element(room.labels.begin(), room.labels.end()));
  RegionMap map = regionsOf(image, room.labels, labels);
  std::vector<epcc::ContactSearchMemory> memory;
  epcc::RegionContacts contacts;
  epcc::findContacts(image, 25, 3.0, map, memory, contacts);
  epcc::RegionMerger merger;
  merger.merge(contacts, parameters, kWhite.withCorrelatedShare(correlated_share), map);
  std::vector<std::int32_t> result;
  for (std::int32_t label = 1; label <= labels; ++label) {
    const auto first = std::find(room.labels.begin(), room.labels.end(), label) - room.labels.begin();
    result.push_back(map.labels[static_cast<std::size_t>(first)]);
  }
  return result;
}

// Wall, strip and wall, the strip 9 mm in front of the first and 18 mm in front of the second: the step between the
// strip and the second is too high. Once the strip is part of the first wall its plane is nearly that wall's, and the
// contact that was refused is judged again.
TEST(MergeRules, WhatARegionThatHasGrownMeetsIsJudgedAgain) {
  const auto walls = [](int first_columns) {
    return changedWall(first_columns + 90, 120, [&](int, int column, float& depth) {
      const int label = column < first_columns ? 1 : column < first_columns + 10 ? 2 : 3;
      depth += label == 1 ? 0.0f : label == 2 ? -0.009f : 0.009f;
      return label;
    });
  };
  EXPECT_EQ(mergedLabels(walls(80), {}), (std::vector<std::int32_t>{1, 1, 1}));
}

// Walls side by side, of which a plane leaves a quarter of their distance, rms, and the tolerance is for the smaller:
// 1.5 standard deviations of 6 mm allow a distance of 25 mm.
TEST(MergeRules, WhiteErrorMovesNoSurface) {
  const auto merge = [](float behind, double share) {
    const auto room = changedWall(160, 120, [&](int, int column, float& depth) {
      depth += column < 80 ? 0.0f : behind;
      return column < 80 ? 1 : 2;
    });
    epcc::InverseDepthParameters parameters;
    parameters.expert.merging.fragment_tolerance = 0.0;
    return mergedLabels(room, parameters, share).back() == 1;
  };
  for (const float sign : {-1.0f, 1.0f}) {
    EXPECT_TRUE(merge(sign * 0.018f, 1.0));
    EXPECT_FALSE(merge(sign * 0.018f, 0.3));
    EXPECT_FALSE(merge(sign * 0.018f, 0.0));
    EXPECT_TRUE(merge(sign * 0.010f, 0.0)) << "half of the tolerance stays";
  }
}

// Two halves interleaved like combs, one so many metres behind the other: 6 mm are one standard deviation there.
TEST(MergeRules, ARaggedBorderWidensTheToleranceUnlessThereIsAStep) {
  const auto merge = [](float behind, double tolerance, double gain) {
    const auto room = changedWall(160, 120, [&](int row, int column, float& depth) {
      const int label = column < (row % 4 < 2 ? 60 : 100) ? 1 : 2;
      if (label == 2) depth += behind;
      return label;
    });
    epcc::InverseDepthParameters parameters;
    parameters.region_tolerance = tolerance;
    parameters.expert.merging.fragment_tolerance = 0.0;
    parameters.expert.merging.max_ragged_gain = gain;
    return mergedLabels(room, parameters).back() == 1;
  };
  EXPECT_TRUE(merge(0.006f, 0.35, 2.0));
  EXPECT_FALSE(merge(0.006f, 0.35, 1.0)) << "only for the ragged border";
  EXPECT_FALSE(merge(0.012f, 0.7, 2.0)) << "a step";
  EXPECT_TRUE(merge(0.012f, 1.4, 1.0)) << "alike without any gain";
}

}  // namespace
