// SPDX-License-Identifier: BSD-3-Clause
// Frames are kept with the numbers of their own planes, and with those of the planes' tracks.
#include "eval/track/waiting_labels.h"

#include <algorithm>
#include <cstddef>
#include <exception>

#include "eval/track/track_files.h"

namespace epcc {

void WaitingLabels::add(const std::string& path, int width, const TrackedFrame& tracked, const PlaneTracker& tracker) {
  frames_.push_back({path, width, tracked.segmentation.labels, tracked.track_of_plane, tracked.label_of_plane});
  frames_.remove_if([&](Frame& frame) {
    const bool is_known = update(frame, tracker);
    if (is_known) write(frame);
    return is_known;
  });
}

void WaitingLabels::writeAll(const PlaneTracker& tracker) {
  frames_.remove_if([&](Frame& frame) {
    update(frame, tracker);
    write(frame);
    return true;
  });
}

void WaitingLabels::rescue() noexcept {
  for (const Frame& frame : frames_) {
    try {
      write(frame);
    } catch (const std::exception&) {  // the same again: what ended the run is told already
    }
  }
  frames_.clear();
}

/// Asks for the labels of its planes; false if one of them may still get one.
bool WaitingLabels::update(Frame& frame, const PlaneTracker& tracker) {
  bool is_known = true;
  for (std::size_t plane = 0; plane < frame.track_of_plane.size(); ++plane) {
    const auto label = tracker.labelOf(frame.track_of_plane[plane]);
    if (label) frame.label_of_plane[plane] = *label;
    is_known = is_known && label;
  }
  return is_known;
}

void WaitingLabels::write(const Frame& frame) {
  std::vector<std::int32_t> labels(frame.planes.size());
  std::transform(frame.planes.begin(), frame.planes.end(), labels.begin(), [&](std::int32_t plane) {
    return plane > 0 ? frame.label_of_plane[static_cast<std::size_t>(plane) - 1] : 0;
  });
  writeLastingLabels(frame.path, frame.width, static_cast<int>(labels.size()) / frame.width, labels);
}

}  // namespace epcc
