// SPDX-License-Identifier: BSD-3-Clause
// The steps on regions, S3's moments to S9: with any number of threads to the last bit what they are with one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "inverse_depth/boundary_refinement.h"
#include "inverse_depth/region_contacts.h"
#include "inverse_depth/surface_bending.h"
#include "inverse_depth/thickness.h"
#include "tests/epcc_segmentation/inverse_depth/region_fixture.h"

namespace {

using epcc::InverseDepthImage;
using epcc::RegionMap;
using epcc::test::kWhite;

constexpr int kLabels = 150;

/// A rough wall with poles before it, holes and frayed regions; higher than wide, or less high than there are bands.
struct Scene {
  InverseDepthImage image;
  std::vector<std::int32_t> labels;

  Scene(int width, int height) {
    auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(width, height));
    std::mt19937 generator(7);
    std::normal_distribution<float> noise(0.0f, 0.004f);
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        float& depth = room.depth[static_cast<std::size_t>(row * width + column)];
        depth += noise(generator);
        if (column % 31 < 4) depth *= 0.6f;
        if (generator() % 50 == 0) depth = 0.0f;
        const auto label = static_cast<std::int32_t>(row / 11 * 10 + (column + row % 3) / 13 + 1);
        labels.push_back(depth <= 0.0f || column % 31 < 4 || generator() % 9 == 0 ? 0 : label);
      }
    image = epcc::test::imageOf(room);
  }
  RegionMap map(int threads) const {
    RegionMap result;
    result.labels = labels;
    result.regions.resize(kLabels);
    result.accumulate(image, threads);
    return result;
  }
};

/// Calls test(scene, threads) for sizes and numbers of threads.
template <typename Test>
void onScenes(const Test& test) {
  for (const auto& [width, height] : {std::pair(120, 160), std::pair(90, 5), std::pair(40, 1)}) {
    const Scene scene(width, height);
    for (const int threads : {2, 3, 20}) {
      SCOPED_TRACE(testing::Message() << width << "x" << height << ", " << threads << " threads");
      test(scene, threads);
    }
  }
}

void expectSame(const RegionMap& map, const RegionMap& expected) {
  EXPECT_EQ(map.labels, expected.labels);
  ASSERT_EQ(map.regions.size(), expected.regions.size());
  for (std::size_t k = 0; k < map.regions.size(); ++k) {
    EXPECT_EQ(map.regions[k].n, expected.regions[k].n);
    EXPECT_EQ(map.regions[k].w_w, expected.regions[k].w_w);
    EXPECT_EQ(map.regions[k].rays_w, expected.regions[k].rays_w);
    EXPECT_EQ(map.regions[k].rays, expected.regions[k].rays);
  }
}

void expectSame(const epcc::RegionContacts& contacts, const epcc::RegionContacts& expected) {
  ASSERT_EQ(contacts.contacts.size(), expected.contacts.size());
  for (std::size_t k = 0; k < contacts.contacts.size(); ++k) {
    EXPECT_EQ(contacts.table.pairs()[k].low, expected.table.pairs()[k].low);
    EXPECT_EQ(contacts.table.pairs()[k].high, expected.table.pairs()[k].high);
    EXPECT_EQ(contacts.contacts[k].count, expected.contacts[k].count);
    EXPECT_TRUE(std::equal(contacts.contacts[k].rays, contacts.contacts[k].rays + 6, expected.contacts[k].rays));
  }
}

TEST(RegionThreads, Moments) {
  onScenes([](const Scene& scene, int threads) { expectSame(scene.map(threads), scene.map(1)); });
}

TEST(RegionThreads, NewLabels) {
  onScenes([](const Scene& scene, int threads) {
    RegionMap map = scene.map(1);
    std::vector<std::int32_t> new_label(kLabels + 1), expected;
    for (std::size_t k = 0; k < new_label.size(); ++k) new_label[k] = static_cast<std::int32_t>(k / 2);
    for (const std::int32_t label : map.labels) expected.push_back(label / 2);
    map.relabel(new_label, threads);
    EXPECT_EQ(map.labels, expected);
  });
}

TEST(RegionThreads, Contacts) {
  onScenes([](const Scene& scene, int threads) {
    const RegionMap map = scene.map(1);
    std::vector<epcc::ContactSearchMemory> memory;
    epcc::RegionContacts contacts, expected;
    epcc::findContacts(scene.image, 5, 3.0, map, memory, expected, 1);
    epcc::findContacts(scene.image, 5, 3.0, map, memory, contacts, threads);
    expectSame(contacts, expected);
  });
}

TEST(RegionThreads, Refinement) {
  bool changes = false;
  onScenes([&](const Scene& scene, int threads) {
    RegionMap map = scene.map(1), expected = scene.map(1);
    epcc::RefinementMemory memory;
    epcc::refineBoundaries(scene.image, epcc::InverseDepthParameters(), expected, memory, 1);
    epcc::refineBoundaries(scene.image, epcc::InverseDepthParameters(), map, memory, threads);
    expectSame(map, expected);
    changes = changes || map.labels != scene.labels;
  });
  EXPECT_TRUE(changes);
}

TEST(RegionThreads, Bending) {
  onScenes([](const Scene& scene, int threads) {
    const RegionMap map = scene.map(1);
    std::vector<std::uint8_t> wanted;
    for (const epcc::PlaneMoments& region : map.regions) wanted.push_back(region.n > 20.0 ? 1 : 0);
    epcc::BendingMemory memory, expected;
    epcc::measureBending(scene.image, map, wanted, expected, 1);
    epcc::measureBending(scene.image, map, wanted, memory, threads);
    for (std::size_t k = 0; k < kLabels; ++k) {
      const epcc::Bending &bending = memory.bending[k], &one = expected.bending[k];
      EXPECT_EQ(bending.rss, one.rss);
      if (!std::isnan(one.gain)) {  // a single row
        EXPECT_EQ(bending.gain, one.gain);
      }
    }
  });
}

TEST(RegionThreads, OccludedContacts) {
  bool any = false;
  onScenes([&](const Scene& scene, int threads) {
    const RegionMap map = scene.map(1);
    epcc::OcclusionMemory memory;
    epcc::RegionContacts contacts, expected;
    epcc::findOccludedContacts(scene.image, 5, 0.5, 3.0, map, memory, expected, 1);
    epcc::findOccludedContacts(scene.image, 5, 0.5, 3.0, map, memory, contacts, threads);
    expectSame(contacts, expected);
    any = any || !contacts.contacts.empty();
  });
  EXPECT_TRUE(any);
}

TEST(RegionThreads, Thickness) {
  onScenes([](const Scene& scene, int threads) {
    RegionMap map = scene.map(1), expected = scene.map(1);
    epcc::ThicknessMemory memory;
    epcc::rejectThin(scene.image, epcc::InverseDepthParameters(), kWhite, 1, expected, memory, 1);
    epcc::rejectThin(scene.image, epcc::InverseDepthParameters(), kWhite, 1, map, memory, threads);
    expectSame(map, expected);
  });
}

}  // namespace
