// SPDX-License-Identifier: BSD-3-Clause
// Runs of one label along scan lines -> line segments.
#include "epcc_segmentation/line_fit.h"

#include <vector>

#include "geometry/sensor_cloud.h"
#include "metric/scan_line.h"
#include "metric/segment_record.h"
#include "segment_fit.h"

namespace epcc {

namespace {

constexpr std::size_t kFewestLineSamples = 3;

ClusteredLine lineThrough(const std::vector<const ScanSample*>& samples, const ScanLine& scan_line) {
  ClusteredLine line;
  LinePrototype& prototype = line.prototype;
  for (const ScanSample* sample : samples) prototype.statistics.add(sample->t);
  prototype.normal = smallestEigenvector(prototype.statistics.covariance);
  prototype.resetVariance();
  line.first = samples.front()->position;
  line.last = samples.back()->position;
  line.a = scan_line.lift(prototype.project(samples.front()->t));
  line.b = scan_line.lift(prototype.project(samples.back()->t));
  return line;
}

void fitColumns(const DepthFrame& view, const SensorModel& sensor, SegmentFitter& fitter, PlaneSegmentation& result) {
  ScanLine scan_line;
  std::vector<const ScanSample*> samples;
  fitter.setStride(1);
  for (int column = 0; column < view.width(); ++column) {
    readScanLine(view, sensor, column, scan_line);
    std::int32_t label = 0;
    const auto finish = [&] {
      if (label != 0 && samples.size() >= kFewestLineSamples) {
        result.segments.push_back(lineSegmentOf(view, column, lineThrough(samples, scan_line)));
        result.segments.back().label = label;
        fitter.fit(samples, result.segments.back());
      }
      samples.clear();
    };
    for (const ScanSample& sample : scan_line.samples) {
      const std::int32_t next = result.labels[view.index(sample.position, column)];
      if (next != label) finish();
      label = next;
      samples.push_back(&sample);
    }
    finish();
  }
}

}  // namespace

bool fitLines(const DepthFrame& frame, const SensorModel& sensor, ScanDirection scan, PlaneSegmentation& segmentation) {
  segmentation.segments.clear();
  const auto size = static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height());
  if (frame.empty() || segmentation.labels.size() != size) return false;
  SensorCloud cloud;
  const DepthFrame own = inSensorFrame(frame, cloud);
  PlaneSegmentation in_sensor_frame;
  if (frame.geometry() != nullptr)
    cloud.takeLabels(segmentation.labels, in_sensor_frame.labels);
  else
    in_sensor_frame.labels.swap(segmentation.labels);
  SegmentFitter fitter(sensor, ErrorCorrelation::of(sensor));
  if (scan != ScanDirection::Rows) fitColumns(own, sensor, fitter, in_sensor_frame);
  if (scan != ScanDirection::Columns && isPerspective(own.projection()))
    fitColumns(own.transposed(), sensor, fitter, in_sensor_frame);
  fitter.finish(in_sensor_frame.segments.data());
  if (frame.geometry() != nullptr)
    cloud.giveBack(in_sensor_frame);
  else
    in_sensor_frame.labels.swap(segmentation.labels);
  segmentation.segments.swap(in_sensor_frame.segments);
  return true;
}

}  // namespace epcc
