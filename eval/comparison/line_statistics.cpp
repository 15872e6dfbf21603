// SPDX-License-Identifier: BSD-3-Clause
// Runs the paper mode on a frame and counts the line segments of the result.
#include "eval/comparison/line_statistics.h"

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "epcc_segmentation/plane_extractor.h"
#include "eval/program/frame_sensor.h"

namespace epcc {
namespace {

/// Measured pixels, by column or by row.
std::vector<int> samplesOfLines(const DepthImage& depth, ScanDirection scan) {
  const bool rows = scan == ScanDirection::Rows;
  std::vector<int> samples(static_cast<std::size_t>(rows ? depth.height : depth.width), 0);
  for (int row = 0; row < depth.height; ++row)
    for (int column = 0; column < depth.width; ++column)
      if (depth.at(row, column) > 0.0F) ++samples[static_cast<std::size_t>(rows ? row : column)];
  return samples;
}

}  // namespace

LineStatistics lineStatistics(const LabelledFrame& frame, const Parameters& parameters, const std::string& sensor) {
  const DepthFrame image = DepthFrame::fromDepth(frame.depth.data.data(), frame.camera.camera);
  Parameters with_lines = parameters;
  with_lines.line_segments = true;
  PlaneExtractor extractor(with_lines, frameSensor(sensor, frame.camera.noise, image, frame.name + ".json").model);
  PlaneSegmentation segmentation;
  if (!extractor.extract(image, segmentation)) throw std::runtime_error(frame.name + ": " + extractor.error());

  std::int64_t lines = 0, samples = 0, members = 0;
  for (const int count : samplesOfLines(frame.depth, parameters.scan)) {
    lines += count > 0 ? 1 : 0;
    samples += count;
  }
  for (const LineSegment& segment : segmentation.segments) members += segment.samples;
  LineStatistics result;
  if (lines == 0) return result;
  result.segments_per_line = static_cast<double>(segmentation.segments.size()) / static_cast<double>(lines);
  result.pixel_share = static_cast<double>(members) / static_cast<double>(samples);
  return result;
}

}  // namespace epcc
