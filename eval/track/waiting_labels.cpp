// SPDX-License-Identifier: BSD-3-Clause
// Frames are kept with the numbers of their own planes, and with those of the planes' tracks.
#include "eval/track/waiting_labels.h"

#include <algorithm>

#include "eval/track/track_files.h"

namespace epcc {

void WaitingLabels::add(const std::string& path, int width, const TrackedFrame& tracked, const PlaneTracker& tracker) {
  frames_.push_back({path, width, tracked.segmentation.labels, tracked.track_of_plane});
  frames_.remove_if([&](const Frame& frame) { return writeIfKnown(frame, tracker, true); });
}

void WaitingLabels::writeAll(const PlaneTracker& tracker) {
  frames_.remove_if([&](const Frame& frame) { return writeIfKnown(frame, tracker, false); });
}

bool WaitingLabels::writeIfKnown(const Frame& frame, const PlaneTracker& tracker, bool wait) {
  std::vector<std::int32_t> label_of_plane = {0};
  for (const int track : frame.track_of_plane) {
    const auto label = tracker.labelOf(track);
    if (!label && wait) return false;
    label_of_plane.push_back(label.value_or(0));
  }
  std::vector<std::int32_t> labels(frame.planes.size());
  std::transform(frame.planes.begin(), frame.planes.end(), labels.begin(),
                 [&](std::int32_t plane) { return label_of_plane[static_cast<std::size_t>(std::max(plane, 0))]; });
  writeLastingLabels(frame.path, frame.width, static_cast<int>(labels.size()) / frame.width, labels);
  return true;
}

}  // namespace epcc
