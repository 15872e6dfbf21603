// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1 on its own, line by line.
#include "eval/comparison/line_statistics.h"

#include "eval/program/frame_sensor.h"
#include "metric/line_clustering.h"
#include "metric/scan_line.h"

namespace epcc {

LineStatistics lineStatistics(const LabelledFrame& frame, const Parameters& parameters, const std::string& sensor) {
  const DepthFrame image = DepthFrame::fromDepth(frame.depth.data.data(), frame.camera.camera);
  const DepthFrame view = parameters.scan == ScanDirection::Rows ? image.transposed() : image;
  const SensorModel model = frameSensor(sensor, frame.camera.noise, image, frame.name + ".json").model;
  LineClustering clustering(parameters.paper);
  ScanLine line;
  LineSegments segments;
  std::size_t lines = 0, samples = 0, members = 0, found = 0;
  for (int column = 0; column < view.width(); ++column) {
    readScanLine(view, model, column, line);
    if (line.samples.empty()) continue;
    clustering.cluster(line, segments);
    ++lines;
    samples += line.samples.size();
    members += segments.members.size();
    found += segments.segments.size();
  }
  LineStatistics result;
  if (lines == 0) return result;
  result.segments_per_line = static_cast<double>(found) / static_cast<double>(lines);
  result.pixel_share = static_cast<double>(members) / static_cast<double>(samples);
  return result;
}

}  // namespace epcc
