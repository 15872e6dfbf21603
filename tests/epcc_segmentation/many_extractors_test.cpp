// SPDX-License-Identifier: BSD-3-Clause
// Eight extractors in eight threads, with threads of their own some of them: each finds what it finds alone.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/support/rendered_room.h"

namespace epcc {
namespace {

constexpr int kExtractors = 8, kFramesEach = 6;

/// All modes, given and measured sensors, one thread and several.
PlaneExtractor extractorNumber(int number) {
  Parameters parameters = number % 4 == 3 ? Parameters::forPaper() : Parameters();
  parameters.threads = 1 + number % 3;
  if (number % 4 == 1) parameters.scan = ScanDirection::Columns;
  PlaneExtractor extractor(parameters);
  if (number % 2 == 1) extractor.setSensor(SensorModel::axial(0.001, 0.001));
  return extractor;
}

/// Labels and planes of every frame, one after the other.
std::vector<double> resultsOf(int number, const std::vector<test::RenderedRoom>& rooms) {
  PlaneExtractor extractor = extractorNumber(number);
  PlaneSegmentation result;
  std::vector<double> all;
  for (int i = 0; i < kFramesEach; ++i) {
    const auto& room = rooms[static_cast<std::size_t>(number + i) % rooms.size()];
    if (!extractor.extract(room.frame(), result)) return {};
    all.insert(all.end(), result.labels.begin(), result.labels.end());
    for (const Plane& plane : result.planes) {
      all.insert(all.end(), plane.coefficients.data(), plane.coefficients.data() + 4);
      all.insert(all.end(), plane.coefficients_covariance.data(), plane.coefficients_covariance.data() + 16);
    }
  }
  return all;
}

TEST(ManyExtractors, EightInEightThreadsFindWhatEachFindsAlone) {
  std::vector<test::RenderedRoom> rooms;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    rooms.push_back(test::renderRoom(test::cornerPlanes(), test::testCamera(80, 60)));
    test::addNoise(rooms.back(), SensorModel::axial(0.001, 0.001), seed);
  }
  std::vector<std::vector<double>> alone, together(kExtractors);
  for (int i = 0; i < kExtractors; ++i) {
    alone.push_back(resultsOf(i, rooms));
    ASSERT_GT(alone.back().size(), static_cast<std::size_t>(kFramesEach * 80 * 60)) << i << " finds planes";
  }
  std::atomic<int> ready{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < kExtractors; ++i)
    threads.emplace_back([&, i] {
      ++ready;
      while (ready < kExtractors) std::this_thread::yield();
      together[static_cast<std::size_t>(i)] = resultsOf(i, rooms);
    });
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < kExtractors; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_TRUE(together[at] == alone[at]) << "extractor " << i;
  }
}

}  // namespace
}  // namespace epcc
