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
  /// The same where the run ends early, by the labels that were known when the last frame was added: what has ended it
  /// may have taken the tracker's map. Images that cannot be written, as on a disk that is full, are left out.
  void rescue() noexcept;

 private:
  struct Frame {
    std::string path;
    int width = 0;
    std::vector<std::int32_t> planes;  ///< row-major, the frame's own, 0 none
    std::vector<int> track_of_plane;
    std::vector<std::int32_t> label_of_plane;  ///< as far as they are known
  };
  static bool update(Frame& frame, const PlaneTracker& tracker);
  static void write(const Frame& frame);

  std::list<Frame> frames_;
};

}  // namespace epcc
