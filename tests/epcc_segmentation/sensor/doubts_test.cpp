// SPDX-License-Identifier: BSD-3-Clause
#include "epcc_segmentation/doubts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "tests/support/rendered_room.h"

namespace {

epcc::Doubts doubtsAbout(const epcc::DepthFrame& frame) {
  epcc::PlaneExtractor extractor;
  epcc::PlaneSegmentation result;
  EXPECT_TRUE(extractor.extract(frame, result)) << extractor.error();
  const epcc::Doubts outside = epcc::Doubts::of(frame, epcc::estimateSensor(frame));
  EXPECT_EQ(outside.inWords(), result.doubts.inWords());
  return result.doubts;
}

epcc::test::RenderedRoom doubtfulRoom() {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(640, 480));
  epcc::test::addNoise(room, epcc::SensorModel::axial(0.005, 0.0, 1.0), 5);
  return room;
}

std::uint16_t swapped(std::uint16_t value) {
  return static_cast<std::uint16_t>(value << 8 | value >> 8);
}

/// The room in millimetres.
std::vector<std::uint16_t> wholeNumbers(const epcc::test::RenderedRoom& room) {
  std::vector<std::uint16_t> values;
  for (const float z : room.depth) values.push_back(static_cast<std::uint16_t>(std::lround(1000.0F * z)));
  return values;
}

std::vector<std::uint16_t> swapped(std::vector<std::uint16_t> values) {
  for (std::uint16_t& value : values) value = swapped(value);
  return values;
}

}  // namespace

TEST(Doubts, ThereAreNoneAboutAScene) {
  const auto room = doubtfulRoom();
  EXPECT_FALSE(doubtsAbout(room.frame()).any()) << doubtsAbout(room.frame()).inWords();
}

TEST(Doubts, SwappedBytesAreNamed) {
  auto room = doubtfulRoom();
  const auto values = swapped(wholeNumbers(room));
  for (std::size_t i = 0; i < values.size(); ++i) room.depth[i] = 0.001F * static_cast<float>(values[i]);
  EXPECT_NE(doubtsAbout(room.frame()).inWords().find("bytes"), std::string::npos);
}

TEST(Doubts, SwappedBytesOfWholeNumbersAreKnownForSure) {
  const auto room = doubtfulRoom();
  const auto values = wholeNumbers(room), other_way_round = swapped(values);
  const auto frame = [&](const std::vector<std::uint16_t>& image) {
    return epcc::DepthFrame::fromDepth(epcc::DepthView<std::uint16_t>{image.data(), 640, 480}, room.camera);
  };
  EXPECT_FALSE(doubtsAbout(frame(values)).any());
  for (const auto& swapped_frame : {frame(other_way_round), frame(other_way_round).transposed()}) {
    EXPECT_TRUE(doubtsAbout(swapped_frame).bytes_are_swapped);
    EXPECT_NE(doubtsAbout(swapped_frame).inWords().find("wrong order"), std::string::npos);
    EXPECT_EQ(doubtsAbout(swapped_frame).inWords().find("is this a depth image"), std::string::npos);
  }
}

TEST(Doubts, ByteOrderOfRowsAnywhereInMemory) {
  const auto values = wholeNumbers(doubtfulRoom()), other_way_round = swapped(values);
  const auto lastRow = [](const std::vector<std::uint16_t>& image) { return image.data() + 479 * 640; };
  EXPECT_FALSE(epcc::bytesAreSwapped({lastRow(values), 640, 480, -1280}));
  EXPECT_TRUE(epcc::bytesAreSwapped({lastRow(other_way_round), 640, 480, -1280}));
  EXPECT_TRUE(epcc::bytesAreSwapped({other_way_round.data(), 320, 480, 1280}));
}

TEST(Doubts, ByteOrderThatCannotBeToldIsTakenAsRight) {
  std::mt19937 random(2);
  auto noise = wholeNumbers(doubtfulRoom()), coarse = noise, few = noise;
  for (auto& value : noise) value = static_cast<std::uint16_t>(random());
  for (auto& value : coarse) value = static_cast<std::uint16_t>(value / 10 * 256);  // bytes below are empty
  for (auto& value : few) value = random() % 100 < 3 ? swapped(value) : std::uint16_t{0};
  const std::vector<std::uint16_t> none(noise.size(), 0), beyond(noise.size(), 65535), flat(noise.size(), 2000);
  for (const auto& image : {noise, coarse, few, none, beyond, flat})
    EXPECT_FALSE(epcc::bytesAreSwapped({image.data(), 640, 480}));
  EXPECT_FALSE(epcc::bytesAreSwapped({}));
  EXPECT_FALSE(epcc::bytesAreSwapped({noise.data(), 1, 1}));
}

// What some renderers and drivers give where there is no depth: the end of their range, or a millimetre.
TEST(Doubts, ManyPixelsAtTheEndOfTheRangeAreNamed) {
  for (const float limit : {10.0F, 0.001F}) {
    auto room = doubtfulRoom();
    for (int row = 0; row < 480; ++row)
      for (int column = 0; column < 640; ++column)
        if (row / 40 % 3 == 0 && column / 40 % 3 == 0) room.depth[static_cast<std::size_t>(row * 640 + column)] = limit;
    const epcc::Doubts doubts = doubtsAbout(room.frame());
    EXPECT_NEAR(doubts.limit_share, 0.11, 0.03) << limit;
    EXPECT_NEAR(doubts.limit_depth / static_cast<double>(limit), 1.0, 1e-6);
    EXPECT_NE(doubts.inWords().find("leave that value out"), std::string::npos) << doubts.inWords();
  }
}

TEST(Doubts, AWallOfOneDepthIsAWall) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(640, 480));
  for (float& z : room.depth) z = std::min(z, 2.0F);  // nothing beyond, and nothing stands apart from it
  EXPECT_EQ(doubtsAbout(room.frame()).limit_share, 0.0);
  for (float& z : room.depth) z = 0.05F * std::round(z / 0.05F);  // coarse steps
  EXPECT_EQ(doubtsAbout(room.frame()).limit_share, 0.0);
  room.depth.assign(room.depth.size(), 2.0F);
  EXPECT_EQ(doubtsAbout(room.frame()).limit_share, 0.0);
}

TEST(Doubts, FewPixelsAreSaid) {
  auto room = doubtfulRoom();
  std::mt19937 random(2);
  for (float& z : room.depth)
    if (random() % 100 >= 3) z = 0.0F;
  EXPECT_NEAR(doubtsAbout(room.frame()).scattered_share, 0.03, 0.005);
  EXPECT_NE(doubtsAbout(room.frame()).inWords().find("only 3"), std::string::npos);
}

TEST(Doubts, ASensorThatCannotBeMeasuredIsGeneric) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(40, 30));
  for (int i = 0; i < 40 * 30; ++i)
    if (i % 40 > 6) room.depth[static_cast<std::size_t>(i)] = 0.0F;
  EXPECT_TRUE(doubtsAbout(room.frame()).sensor_is_generic);
}
