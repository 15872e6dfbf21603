// SPDX-License-Identifier: BSD-3-Clause
// What every method shares: clean results, errors in words, the clock, the planes of the labels.
#include "baselines/plane_segmenter.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>

#include "baselines/quiet_pcl.h"
#include "epcc_segmentation/plane_fit.h"

namespace epcc {

namespace {

void clear(const DepthFrame& frame, PlaneSegmentation& result) {
  result.width = std::max(0, frame.width());
  result.height = std::max(0, frame.height());
  result.labels.assign(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height), 0);
  result.planes.clear();
  result.segments.clear();
}

}  // namespace

double PlaneSegmenter::now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool PlaneSegmenter::fail(const std::string& message) {
  error_ = message;
  return false;
}

bool PlaneSegmenter::segment(const SegmenterInput& input, PlaneSegmentation& result) {
  error_.clear();
  conversion_seconds_ = 0.0;
  fit_seconds_ = 0.0;
  clear(input.frame, result);
  const double start = now();
  const bool done = runGuarded(input, result);
  seconds_ = std::max(1e-9, now() - start - conversion_seconds_ - fit_seconds_);
  if (!done) clear(input.frame, result);
  return done;
}

bool PlaneSegmenter::runGuarded(const SegmenterInput& input, PlaneSegmentation& result) {
  if (input.frame.empty()) return fail("the frame is empty or its camera is invalid");
  const std::string sensor_problem = input.sensor.validate();
  if (!sensor_problem.empty()) return fail(sensor_problem);
  if (input.frame.width() < 2 || input.frame.height() < 2) return true;
  try {
    const QuietPcl quiet;
    return run(input, result);
  } catch (const std::bad_alloc&) {
    return fail("needs more memory than there is");
  } catch (const std::exception& problem) {
    return fail(problem.what());
  }
}

void PlaneSegmenter::fitLabels(const SegmenterInput& input, std::int32_t label_count, PlaneSegmentation& result) {
  const double start = now();
  Eigen::Vector3d point;
  for (int row = 0; row < input.frame.height(); ++row)
    for (int column = 0; column < input.frame.width(); ++column)
      if (!input.frame.point(row, column, point)) result.labels[input.frame.index(row, column)] = 0;
  fitPlanes(input.frame, input.sensor, label_count, result);
  fit_seconds_ += now() - start;
}

}  // namespace epcc
