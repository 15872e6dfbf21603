// SPDX-License-Identifier: BSD-3-Clause
// Points and lines in a plane as a picture, in pixels and as SVG.
#pragma once

#include <string>
#include <vector>

#include "datasets/files/image.h"
#include "eval/lines/log_lines.h"

namespace epcc {

/// What is drawn, metres; x to the right, y up.
struct LineMap {
  struct Segment {
    Vector2 start, end;
    Rgb color;
  };
  std::string title;
  std::vector<Vector2> points;     ///< grey
  std::vector<Segment> segments;   ///< over the points
  std::vector<Vector2> positions;  ///< of the sensor, dark
  double segment_width = 3.0;      ///< pixels
};

/// A scan from its sensor, every line in a colour of its own.
LineMap scanMap(const LaserRecord& record, const LaserLines& lines, const std::string& title);
/// All scans that have a pose, in the frame of the odometry; a line's colour is its direction.
LineMap logMap(const LaserLog& log, const LogLines& lines, const std::string& title);

/// A picture 1200 pixels wide or high, whichever is longer, with a bar of a round length as its scale.
ColorImage drawMap(const LineMap& map);
/// The same picture as SVG.
std::string mapSvg(const LineMap& map);

}  // namespace epcc
