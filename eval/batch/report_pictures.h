// SPDX-License-Identifier: BSD-3-Clause
// The frames that the report shows, and their pictures.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "datasets/sources/frame_source.h"
#include "eval/batch/foremost.h"
#include "eval/batch/stored_frame.h"
#include "eval/measures/frame_score.h"

namespace epcc {

/// A frame to be shown.
struct PicturedFrame {
  StoredFrame frame;
  std::string folder;  ///< of the run that holds it
  std::string why;     ///< "worst, first"
};

/// The first frames of each data set, and those that the first method did worst and best on. Of two equal ones the
/// earlier is taken, so the choice among all frames is one among the choices of the shards.
class PictureChoice {
 public:
  /// Of every data set the first `each` frames, the worst `each` and the best `each`.
  explicit PictureChoice(std::size_t each) : each_(each) {}
  /// In the order of the frames. Frames that no method could be scored on are passed over.
  void add(const StoredFrame& frame, const std::string& folder);
  /// By data set, then by frame.
  std::vector<PicturedFrame> chosen() const;

 private:
  using Key = std::pair<FrameScore, std::size_t>;
  using Kept = Foremost<Key, PicturedFrame>;
  struct Kinds {
    Kept first, worst, best;
  };

  std::size_t each_;
  std::vector<Kinds> kinds_;  ///< by data set
  std::map<std::string, std::size_t> place_of_;
};

/// Small pictures: number 0 is the depth image, 1 the truth, then the methods.
std::string picturePath(const PicturedFrame& pictured, std::size_t number);

/// Draws them from the source and the label images in the frame's folder. A frame or label image that is no longer
/// there, or too large to be drawn, costs its pictures. Throws OutputError.
void drawPictures(const PicturedFrame& pictured, const FrameSource& source);

}  // namespace epcc
