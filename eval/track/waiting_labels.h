// SPDX-License-Identifier: BSD-3-Clause
// Label images of frames with planes that have no label yet: they are written once it is known which they get.
#pragma once

#include <cstdint>
#include <list>
#include <string>
#include <vector>

#include "epcc_segmentation/plane_tracker.h"

namespace epcc {

/// A plane is seen in some frames before it has a label (TrackerParameters::confirm_frames). Its pixels in those frames
/// get it, too, unless it never gets one. So many frames wait at most.
class WaitingLabels {
 public:
  /// The frame that the tracker has just taken, of `width` pixels a row. Written are all frames whose planes wait for a
  /// label no longer, this one at once if none of its planes does. OutputError as writeLastingLabels().
  void add(const std::string& path, int width, const TrackedFrame& tracked, const PlaneTracker& tracker);
  /// Writes all of them, planes without a label as none.
  void writeAll(const PlaneTracker& tracker);

 private:
  struct Frame {
    std::string path;
    int width = 0;
    std::vector<std::int32_t> planes;  ///< row-major, the frame's own, 0 none
    std::vector<int> track_of_plane;
  };
  static bool writeIfKnown(const Frame& frame, const PlaneTracker& tracker, bool wait);

  std::list<Frame> frames_;
};

}  // namespace epcc
