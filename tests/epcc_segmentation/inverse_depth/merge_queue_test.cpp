// SPDX-License-Identifier: BSD-3-Clause
// What S4 merges with: the queue against a sorted set, planes in lanes against single ones.
#include "inverse_depth/merge_queue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "inverse_depth/plane_batch.h"
#include "tests/support/vector_units.h"

namespace {

TEST(MergeQueue, GivesTheContactsInTheOrderOfTheirLastCosts) {
  constexpr int kContacts = 300;
  std::mt19937 generator(3);
  epcc::MergeQueue queue;
  for (int frame = 0; frame < 3; ++frame) {  // its memory is kept
    queue.clear(kContacts);
    std::set<std::pair<double, int>> expected;
    std::map<int, double> cost_of;
    const auto forget = [&](int contact) {
      const auto known = cost_of.find(contact);
      if (known == cost_of.end()) return;
      expected.erase({known->second, contact});
      cost_of.erase(known);
    };
    for (int step = 0; step < 20000; ++step) {
      const int contact = static_cast<int>(generator() % kContacts);
      switch (generator() % 4) {
        case 0:
          if (queue.empty()) break;
          ASSERT_EQ(expected.begin()->second, queue.pop());
          forget(expected.begin()->second);
          break;
        case 1:
          queue.remove(contact);
          forget(contact);
          break;
        default: {
          const double cost = (static_cast<int>(generator() % 50) - 10) / 40.0;  // equal ones and negative ones
          queue.set(contact, cost);
          forget(contact);
          cost_of[contact] = cost;
          expected.insert({cost, contact});
        }
      }
      ASSERT_EQ(queue.empty(), expected.empty());
    }
    for (const auto& [cost, contact] : expected) ASSERT_EQ(queue.pop(), contact) << cost;
    ASSERT_TRUE(queue.empty());
  }
}

void expectSame(const epcc::SumsPlane& plane, const epcc::SumsPlane& expected) {
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  EXPECT_PRED2(same, plane.x, expected.x);
  EXPECT_PRED2(same, plane.y, expected.y);
  EXPECT_PRED2(same, plane.z, expected.z);
  EXPECT_PRED2(same, plane.rss, expected.rss);
  EXPECT_PRED2(same, plane.slope_factor, expected.slope_factor);
}

TEST(PlaneBatch, HasThePlanesOfItsRegionsToTheBitOnEachUnit) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int count = 0; count <= epcc::PlaneBatch::kSize; ++count) {
    epcc::PlaneBatch batch;
    std::vector<epcc::RegionSums> regions;
    for (int k = 0; k < count; ++k) {
      epcc::PlaneMoments moments;
      for (int pixel = 0; pixel < 30; ++pixel)
        moments.add({any(generator), any(generator), 1.0}, 0.5 + 0.2 * any(generator), 1e-4);
      regions.emplace_back(moments);
      batch.add(regions.back());
    }
    epcc::test::onEveryVectorUnit([&] {
      epcc::fitPlanes(batch);
      for (int k = 0; k < count; ++k) {
        const epcc::SumsPlane plane = batch.plane(k), expected(regions[static_cast<std::size_t>(k)]);
        expectSame(plane, expected);
      }
    });
  }
}

// A pixel 1e-110 m away, as no sensor gives: its normal matrix has an inverse beyond all numbers.
TEST(PlaneBatch, WhatHasNoPlaneHasNoneOnEachUnit) {
  epcc::PlaneMoments moments;
  moments.add({0.1, 0.2, 1.0}, 1e110, 1e-220);
  const epcc::RegionSums region(moments);
  epcc::PlaneBatch batch;
  batch.add(region);
  const epcc::SumsPlane expected(region);
  EXPECT_TRUE(std::isnan(expected.rss)) << "not a perfect fit";
  epcc::test::onEveryVectorUnit([&] {
    epcc::fitPlanes(batch);
    expectSame(batch.plane(0), expected);
  });
}

}  // namespace
