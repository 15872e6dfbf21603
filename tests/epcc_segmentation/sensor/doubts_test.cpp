// SPDX-License-Identifier: BSD-3-Clause
#include "epcc_segmentation/doubts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

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

epcc::test::RenderedRoom noisyRoom() {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(640, 480));
  epcc::test::addNoise(room, epcc::SensorModel::axial(0.005, 0.0, 1.0), 5);
  return room;
}

}  // namespace

TEST(Doubts, ThereAreNoneAboutAScene) {
  const auto room = noisyRoom();
  EXPECT_FALSE(doubtsAbout(room.frame()).any()) << doubtsAbout(room.frame()).inWords();
}

TEST(Doubts, SwappedBytesAreNamed) {
  auto room = noisyRoom();
  for (float& z : room.depth) {
    const auto millimetres = static_cast<std::uint16_t>(std::lround(1000.0F * z));
    z = 0.001F * static_cast<float>(static_cast<std::uint16_t>(millimetres << 8 | millimetres >> 8));
  }
  EXPECT_NE(doubtsAbout(room.frame()).inWords().find("bytes"), std::string::npos);
}

TEST(Doubts, FewPixelsAreSaid) {
  auto room = noisyRoom();
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
