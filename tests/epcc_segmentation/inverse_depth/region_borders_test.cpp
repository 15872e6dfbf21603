// SPDX-License-Identifier: BSD-3-Clause
// What S4 to S8 stand on: bits of borders, pairs, contacts and refined labels, against plain loops, on every vector
// unit.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>

#include "epcc_segmentation/vector_unit.h"
#include "inverse_depth/boundary_refinement.h"
#include "inverse_depth/label_borders.h"
#include "inverse_depth/region_contacts.h"
#include "inverse_depth/relabelling.h"
#include "tests/epcc_segmentation/inverse_depth/region_fixture.h"

namespace {

using epcc::InverseDepthImage;
using epcc::RegionMap;
using epcc::RegionPair;

/// Blobs of the labels 0 to `labels`, and single pixels of others.
std::vector<std::int32_t> speckledLabels(int width, int height, int labels, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<std::int32_t> any(0, labels);
  std::vector<std::int32_t> blobs(1000);
  for (auto& label : blobs) label = any(generator);
  std::vector<std::int32_t> result;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      result.push_back(generator() % 20 == 0
                           ? any(generator)
                           : blobs[static_cast<std::size_t>(row / 7 * 31 + column / 9) % blobs.size()]);
  return result;
}

/// Runs `test` on each vector unit that this machine has.
template <typename Test>
void onEachUnit(const Test& test) {
  const std::string before = epcc::vectorUnit();
  for (const std::string& unit : epcc::vectorUnits()) {
    ASSERT_TRUE(epcc::setVectorUnit(unit));
    SCOPED_TRACE(unit);
    test();
  }
  epcc::setVectorUnit(before);
}

// ---- labels ----

TEST(LabelBorders, AreWhereNeighboursDiffer) {
  onEachUnit([] {
    for (const int width : {1, 2, 15, 16, 17, 63, 64, 65, 100, 128, 640}) {
      const int height = 6;
      const auto labels = speckledLabels(width, height, 3, 5);
      epcc::RowBorders borders;
      borders.resize(width);
      for (int row = 0; row < height; ++row) {
        borders.mark(labels.data(), width, height, row);
        for (int column = 0; column < width; ++column) {
          const std::int32_t* label = labels.data() + row * width + column;
          const auto bit = [column](const epcc::RowBits& bits) {
            return (bits[static_cast<std::size_t>(column) / 64] >> column % 64 & 1) != 0;
          };
          ASSERT_EQ(bit(borders.left), column > 0 && label[0] != label[-1]) << width << " " << row << " " << column;
          ASSERT_EQ(bit(borders.above), row > 0 && label[0] != label[-width]) << width << " " << row << " " << column;
          ASSERT_EQ(bit(borders.labelled), label[0] != 0) << width << " " << row << " " << column;
        }
        for (const epcc::RowBits* bits : {&borders.left, &borders.above, &borders.labelled})
          if (width % 64 != 0) {
            ASSERT_EQ(bits->back() >> width % 64, 0U) << width;
          }
      }
    }
  });
}

TEST(LabelBorders, AreListedInOrder) {
  const int width = 200;
  for (const std::uint64_t word :
       {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}, std::uint64_t{0x8100000000000081}}) {
    epcc::PixelList list;
    list.clear(width);
    std::vector<int> expected;
    for (std::size_t k = 0; k < 3; ++k) {
      list.add(word, k);
      for (int bit = 0; bit < 64; ++bit)
        if ((word >> bit & 1) != 0) expected.push_back(static_cast<int>(64 * k) + bit);
    }
    EXPECT_EQ(std::vector<int>(list.begin(), list.end()), expected);
  }
}

TEST(Relabelling, LooksEveryLabelUp) {
  onEachUnit([] {
    const std::vector<std::int32_t> new_label = {0, 1, 1, 0, 4, 2};
    for (const int width : {1, 15, 16, 37, 640}) {
      auto labels = speckledLabels(width, 11, 5, 9);
      auto expected = labels;
      for (auto& label : expected) label = new_label[static_cast<std::size_t>(label)];
      std::vector<std::int32_t> elsewhere(labels.size(), -1);
      epcc::relabelPixels(labels.data(), labels.size(), new_label.data(), elsewhere.data());
      EXPECT_EQ(elsewhere, expected) << width;
      epcc::relabelPixels(labels.data(), labels.size(), new_label.data());
      EXPECT_EQ(labels, expected) << width;
    }
  });
}

// ---- pairs ----

TEST(RegionPairs, KeepTheirNumbersWhileTheTableGrowsAndAreForgotten) {
  epcc::RegionPairTable table;
  for (int round = 0; round < 3; ++round) {
    const auto pairOf = [round](int k) { return RegionPair(1 + k % 321 * (round + 1), 1000 + k / 321); };
    for (int k = 0; k < 50000; ++k) ASSERT_EQ(table.add(pairOf(k)), k);
    for (int k = 0; k < 50000; ++k) ASSERT_EQ(table.add(pairOf(k)), k);
    EXPECT_EQ(table.numberOf({1, 999}), -1);
    table.assign({1, 999}, 7);
    EXPECT_EQ(table.numberOf({999, 1}), 7);
    EXPECT_EQ(table.pairs().size(), 50000U);
    table.clear();
    for (int k = 0; k < 50000; ++k) ASSERT_EQ(table.numberOf(pairOf(k)), -1);
    EXPECT_EQ(table.numberOf({1, 999}), -1);
  }
}

// ---- contacts ----

/// A wall with grooves, ridges and holes.
InverseDepthImage roughWall(int width, int height, unsigned seed) {
  auto room = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(width, height));
  epcc::test::addNoise(room, epcc::test::kWhite, seed);
  std::mt19937 generator(seed);
  for (auto& depth : room.depth) {
    const auto kind = generator() % 20;
    depth = kind == 0 ? 0.0f : kind == 1 ? depth + 0.3f : kind == 2 ? depth - 0.3f : depth;
  }
  return epcc::test::imageOf(room);
}

using PlainContacts = std::map<std::pair<std::int32_t, std::int32_t>, int>;

/// Contacts along the line of `length` pixels from `start` on.
void addContactsOfLine(const InverseDepthImage& image, const std::vector<std::int32_t>& labels, int bridge,
                       std::size_t start, std::size_t step, int length, PlainContacts& contacts) {
  int last = -1;
  for (int i = 0; i < length; ++i) {
    const auto pixel = [&](int k) { return start + static_cast<std::size_t>(k) * step; };
    const std::int32_t label = labels[pixel(i)];
    if (label == 0) continue;
    if (last >= 0 && labels[pixel(last)] != label && i - last <= bridge + 1) {
      const std::size_t farther = image.w[pixel(last)] < image.w[pixel(i)] ? pixel(last) : pixel(i);
      bool parted = false;
      for (int k = last + 1; k < i; ++k) {
        const double error = static_cast<double>(image.w[farther]) - static_cast<double>(image.w[pixel(k)]);
        parted |=
            image.w[pixel(k)] > 0.0f && error > 0.0 && error * error * static_cast<double>(image.weight[farther]) > 9.0;
      }
      const RegionPair pair(labels[pixel(last)], label);
      if (!parted) ++contacts[{pair.low, pair.high}];
    }
    last = i;
  }
}

TEST(RegionContacts, AreThoseOfAWalkAlongEveryLine) {
  std::vector<epcc::ContactSearchMemory> memory;  // kept from one size to the next
  epcc::RegionContacts contacts;
  onEachUnit([&] {
    for (const int labels : {5, 3000})
      for (const int width : {160, 77, 64}) {
        const int height = 50;
        const InverseDepthImage image = roughWall(width, height, 11);
        const RegionMap map = epcc::test::regionsOf(image, speckledLabels(width, height, labels, 12), labels);
        epcc::findContacts(image, 5, 3.0, map, memory, contacts);
        PlainContacts expected;
        for (int row = 0; row < height; ++row)
          addContactsOfLine(image, map.labels, 5, image.index(row, 0), 1, width, expected);
        for (int column = 0; column < width; ++column)
          addContactsOfLine(image, map.labels, 5, image.index(0, column), static_cast<std::size_t>(width), height,
                            expected);
        EXPECT_EQ(contacts.contacts.size(), expected.size());
        for (const auto& [pair, count] : expected) {
          const epcc::Contact* contact = contacts.find({pair.first, pair.second});
          ASSERT_NE(contact, nullptr);
          ASSERT_EQ(contact->count, count);
        }
      }
  });
}

TEST(RegionContacts, SumTheSquaresAcrossThePlane) {
  const InverseDepthImage image = roughWall(40, 30, 3);
  epcc::Contact contact;
  const Eigen::Vector3d q(0.3, -0.2, 0.7);
  double expected = 0.0;
  for (int row = 1; row < 30; ++row) {
    contact.add(image, row, 7, row - 1, 7);
    const double weight = 0.5 * (static_cast<double>(image.weight[image.index(row, 7)]) +
                                 static_cast<double>(image.weight[image.index(row - 1, 7)]));
    const double step = q.dot(0.5 * (image.ray(row, 7) + image.ray(row - 1, 7)));
    expected += weight * step * step;
  }
  EXPECT_EQ(contact.count, 29);
  EXPECT_NEAR(contact.squares(q), expected, 1e-9 * expected);
}

// ---- S5 ----

/// Two images of one width, one above the other, without a contact.
InverseDepthImage stacked(const InverseDepthImage& above, const InverseDepthImage& below) {
  InverseDepthImage both = above;
  both.height = above.height + 1 + below.height;
  both.w.resize(both.w.size() + static_cast<std::size_t>(above.width), 0.0f);
  both.weight.resize(both.w.size(), 0.0f);
  both.along.push_back(0.0);
  both.w.insert(both.w.end(), below.w.begin(), below.w.end());
  both.weight.insert(both.weight.end(), below.weight.begin(), below.weight.end());
  both.along.insert(both.along.end(), below.along.begin(), below.along.end());
  return both;
}

/// Labels of a corner of a room that are wrong along the borders and have holes.
std::vector<std::int32_t> frayed(const std::vector<std::int32_t>& labels, unsigned seed) {
  std::mt19937 generator(seed);
  std::vector<std::int32_t> result = labels;
  for (std::size_t i = 8; i < labels.size(); ++i)
    if (generator() % 3 == 0) result[i] = generator() % 4 == 0 ? 0 : labels[i - 1 - generator() % 8];
  return result;
}

// The frontier is worked through in parts, and the image below is divided otherwise than the one alone.
TEST(BoundaryRefinement, DependsNeitherOnTheOrderOfPixelsNorOnTheVectorUnitNorOnFramesBefore) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  epcc::test::addNoise(room, epcc::test::kWhite, 5);
  const InverseDepthImage image = epcc::test::imageOf(room);
  const RegionMap clean = epcc::test::regionsOf(image, room.labels, 3);
  RegionMap alone = clean;
  alone.labels = frayed(room.labels, 1);
  const auto start = alone.labels;
  epcc::RefinementMemory memory;
  epcc::refineBoundaries(image, epcc::InverseDepthParameters(), alone, memory);
  ASSERT_NE(alone.labels, start);

  const InverseDepthImage both = stacked(image, image);
  onEachUnit([&] {
    RegionMap map = clean;
    map.labels = start;
    map.labels.resize(map.labels.size() + static_cast<std::size_t>(image.width), 0);
    map.labels.insert(map.labels.end(), start.begin(), start.end());
    epcc::refineBoundaries(both, epcc::InverseDepthParameters(), map, memory);
    const auto size = static_cast<std::ptrdiff_t>(start.size());
    EXPECT_EQ(std::vector<std::int32_t>(map.labels.begin(), map.labels.begin() + size), alone.labels);
    EXPECT_EQ(std::vector<std::int32_t>(map.labels.end() - size, map.labels.end()), alone.labels);
  });
}

TEST(BoundaryRefinement, LeavesTheMomentsOfTheNewLabels) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  epcc::test::addNoise(room, epcc::test::kWhite, 5);
  const InverseDepthImage image = epcc::test::imageOf(room);
  // A speck of one of the walls in the midst of it will lose all its pixels.
  auto labels = frayed(room.labels, 1);
  for (auto& label : labels) label = label == 0 ? 0 : label + 1;
  const std::size_t speck = image.index(image.height / 2, image.width / 2);
  labels[speck] = 1;
  RegionMap map = epcc::test::regionsOf(image, labels, 4);
  map.regions[0].rays_w *= 3.0;  // its plane is elsewhere
  epcc::RefinementMemory memory;
  epcc::refineBoundaries(image, epcc::InverseDepthParameters(), map, memory);
  ASSERT_NE(map.labels, labels);
  ASSERT_NE(map.labels[speck], 1);
  const RegionMap expected = epcc::test::regionsOf(image, map.labels, 4);
  EXPECT_EQ(map.regions[0].rays, Eigen::Matrix3d::Zero());
  EXPECT_EQ(map.regions[0].w_w, 0.0);
  for (std::size_t k = 0; k < 4; ++k) {
    const epcc::PlaneMoments &moments = map.regions[k], &other = expected.regions[k];
    EXPECT_EQ(moments.n, other.n);
    EXPECT_NEAR(moments.w_sum, other.w_sum, 1e-9 * other.w_sum);
    EXPECT_NEAR(moments.w_w, other.w_w, 1e-9 * other.w_w);
    EXPECT_LE((moments.rays_w - other.rays_w).norm(), 1e-9 * other.rays_w.norm());
    EXPECT_LE((moments.rays - other.rays).norm(), 1e-9 * other.rays.norm());
  }
}

}  // namespace
