// SPDX-License-Identifier: BSD-3-Clause
// Frames that the tests of the baselines share.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "baselines/plane_segmenter.h"
#include "tests/support/rendered_room.h"

namespace epcc::test {

/// The noise of a good depth camera: 1 mm and 0.5 mm/m^2.
inline SensorModel mildSensor() {
  return SensorModel::axial(0.001, 0.0005);
}

/// Floor and two walls at 320x240 with mild noise.
inline RenderedRoom noisyRoom() {
  RenderedRoom room = renderRoom(cornerPlanes(), testCamera(320, 240));
  addNoise(room, mildSensor(), 7);
  return room;
}

inline SegmenterInput inputOf(const RenderedRoom& room) {
  return {room.frame(), mildSensor(), "room"};
}

/// Share of the pixels of a true plane that the label covering it best holds.
inline double bestCoverage(const RenderedRoom& room, const PlaneSegmentation& result, std::int32_t truth) {
  std::map<std::int32_t, int> hits;
  int size = 0;
  for (std::size_t i = 0; i < room.labels.size(); ++i)
    if (room.labels[i] == truth) {
      ++size;
      if (result.labels[i] > 0) ++hits[result.labels[i]];
    }
  int best = 0;
  for (const auto& hit : hits) best = std::max(best, hit.second);
  return static_cast<double>(best) / size;
}

}  // namespace epcc::test
