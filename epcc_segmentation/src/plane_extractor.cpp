// SPDX-License-Identifier: BSD-3-Clause
// The pipelines of both modes, step by step: scan lines -> line segments -> planes -> labels (Figure 2).
#include "epcc_segmentation/plane_extractor.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>
#include <new>

#include "epcc_segmentation/sensor_estimation.h"
#include "epcc_segmentation/vector_unit.h"
#include "geometry/sensor_cloud.h"
#include "inverse_depth/inverse_depth_pipeline.h"
#include "inverse_depth/scattered_pixels.h"
#include "metric/metric_pipeline.h"
#include "plane_fit_samples.h"
#include "segment_fit.h"
#include "sensor/frame_doubts.h"
#include "sensor/sensor_adaptation.h"
#include "sensor/slow_bending.h"

namespace epcc {

namespace {

constexpr int kAdaptingInterval = 2;  // S0 wants the size alone: half of the blocks, until a stream settles

/// Seconds since the last call or the construction.
class StopWatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// The view whose columns are the scan lines of the paper mode.
DepthFrame scanView(const DepthFrame& frame, ScanDirection scan) {
  return scan == ScanDirection::Rows ? frame.transposed() : frame;
}

/// Labels in the frame's own order -> in that of the caller's arrays, which a transposed view does not share.
void moveLabels(const DepthFrame& frame, std::vector<std::int32_t>& from, std::vector<std::int32_t>& to) {
  if (!frame.isTransposed()) {
    if (to.size() != from.size())
      to = from;  // the first frame: from now on both have their memory
    else
      to.swap(from);
    return;
  }
  to.resize(from.size());
  std::size_t next = 0;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) to[frame.index(row, column)] = from[next++];
}

}  // namespace

/// Both pipelines' memory, kept from frame to frame.
struct PlaneExtractor::Workspace {
  Workspace(const Parameters& parameters, const SensorModel& sensor, bool measures_sensor)
      : metric(parameters, sensor), inverse_depth(parameters, sensor) {
    if (!measures_sensor) estimator.reset(kAdaptingInterval);
  }
  SensorCloud cloud;
  InverseDepthImage image;
  ScatteredPixels scattered;
  SensorEstimator estimator;
  std::vector<double> ratios;  // memory of S0
  MetricPipeline metric;
  InverseDepthPipeline inverse_depth;
  PlaneFitter fitter;
  SlowBending bending;
  std::optional<ErrorCorrelation> measured_error;     // of this frame's sensor
  std::optional<ErrorCorrelation> bent_error;         // the same with slow bending, of the last frame that was measured
  const InverseDepthImage* measured_image = nullptr;  // null if S0 rested
};

PlaneExtractor::PlaneExtractor(const Parameters& parameters, const std::optional<SensorModel>& sensor)
    : parameters_(parameters),
      given_sensor_(sensor.value_or(SensorEstimate().model())),
      sensor_(given_sensor_),
      measures_sensor_(!sensor.has_value()),
      workspace_(std::make_unique<Workspace>(parameters_, sensor_, measures_sensor_)) {}
PlaneExtractor::~PlaneExtractor() = default;
PlaneExtractor::PlaneExtractor(PlaneExtractor&&) noexcept = default;
PlaneExtractor& PlaneExtractor::operator=(PlaneExtractor&&) noexcept = default;

void PlaneExtractor::setParameters(const Parameters& parameters) {
  parameters_ = parameters;
}

void PlaneExtractor::setSensor(const SensorModel& sensor) {
  given_sensor_ = sensor_ = sensor;
  measures_sensor_ = false;
  if (workspace_) workspace_->estimator.reset(kAdaptingInterval);
}

void PlaneExtractor::setSensorAuto() {
  given_sensor_ = sensor_ = SensorEstimate().model();
  measures_sensor_ = true;
  if (!workspace_) return;
  workspace_->estimator.reset();
  workspace_->bending.reset();
  workspace_->bent_error.reset();
}

bool PlaneExtractor::extract(const DepthFrame& frame, PlaneSegmentation& result) try {
  if (!check(frame, result)) return false;
  if (!workspace_) workspace_ = std::make_unique<Workspace>(parameters_, sensor_, measures_sensor_);  // moved away
  if (frame.geometry() == nullptr) {
    extractInSensorFrame(frame, result);
    return true;
  }
  StopWatch watch;
  const DepthFrame own = workspace_->cloud.of(frame, parameters_.threads);
  const double turning = watch.lap();
  result.width = own.width();
  result.height = own.height();
  extractInSensorFrame(own, result);
  watch.lap();
  workspace_->cloud.giveBack(result);
  times_.read += turning;
  times_.result += watch.lap();
  return true;
} catch (const std::bad_alloc&) {
  return fail(Status::OutOfMemory, "out of memory", result);  // short enough to need none
} catch (const std::exception& error) {
  return fail(Status::Failed, error.what(), result);
}

namespace {

/// As many labels as it has places for, each with a plane that is known.
bool isComplete(const KnownView& view, std::size_t planes) {
  if (view.labels == nullptr || view.width <= 0 || view.height <= 0 ||
      view.labels->size() != static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height))
    return false;
  const auto count = static_cast<std::int64_t>(view.plane_of_label.size());
  const auto end = static_cast<std::int32_t>(std::min<std::int64_t>(count, std::numeric_limits<std::int32_t>::max()));
  int other = 0;
  for (const std::int32_t label : *view.labels) other |= static_cast<int>(label < 0) | static_cast<int>(label >= end);
  const auto is_known = [planes](std::int32_t plane) {
    return plane == kNotLookedAt || (plane >= 0 && static_cast<std::size_t>(plane) <= planes);
  };
  return other == 0 && std::all_of(view.plane_of_label.begin(), view.plane_of_label.end(), is_known);
}

}  // namespace

bool PlaneExtractor::extract(const DepthFrame& frame, const KnownPlanes& known, PlaneSegmentation& result,
                             Continuation& continuation) try {
  const bool can_continue = parameters_.mode == Mode::InverseDepth && frame.geometry() == nullptr &&
                            !frame.isTransposed() && isPerspective(frame.projection()) &&
                            std::all_of(known.views.begin(), known.views.end(), [&known](const KnownView& view) {
                              return isComplete(view, known.planes.size());
                            });
  continuation = Continuation();
  continuation.pose = known.pose;
  known_ = can_continue ? &known : nullptr;
  continuation_ = &continuation;
  const bool done = extract(frame, result);
  known_ = nullptr;
  continuation.continues.resize(result.planes.size(), -1);
  return done;
} catch (const std::bad_alloc&) {
  return fail(Status::OutOfMemory, "out of memory", result);
}

void PlaneExtractor::extractInSensorFrame(const DepthFrame& frame, PlaneSegmentation& result) {
  const bool paper = parameters_.mode == Mode::Paper;
  workspace_->measured_error.reset();
  if (!paper || measures_sensor_) result.doubts.bytes_are_swapped = bytesAreSwapped(frame.wholeNumbers());
  const int count = paper ? extractMetric(frame, result) : extractInverseDepth(frame, result);
  const FitSamples samples = paper ? FitSamples{1, 0, false} : workspace_->inverse_depth.fitSamples();
  StopWatch watch;
  ErrorCorrelation error = workspace_->measured_error.value_or(ErrorCorrelation::of(sensor_));
  workspace_->fitter.lendErrorCorrelation(error);
  workspace_->fitter.fit(frame, sensor_, count, samples, parameters_.threads, result);
  if (workspace_->measured_error && workspace_->measured_image != nullptr) {
    workspace_->bent_error.reset();
    if (workspace_->bending.canMeasure(frame, *workspace_->measured_image, samples))
      workspace_->bent_error =
          workspace_->bending.update(workspace_->estimator.lastBlocks(), *workspace_->measured_image, error,
                                     {result.labels, result.planes, sensor_, workspace_->fitter});
  }
  if (workspace_->measured_error && workspace_->bent_error) {
    error = *workspace_->bent_error;
    workspace_->fitter.correlate(error, result.planes);
  }
  if (known_ != nullptr) {
    const std::vector<int>& known = workspace_->inverse_depth.knownPlanes();
    continuation_->continues.assign(result.planes.size(), -1);
    for (std::size_t k = 0; k < known.size(); ++k) {
      const std::int32_t label = workspace_->fitter.newLabels()[k + 1];
      if (label > 0) continuation_->continues[static_cast<std::size_t>(label) - 1] = known[k];
    }
  }
  if (parameters_.line_segments) listSegments(frame, error, result);
  times_.result += watch.lap();
}

int PlaneExtractor::extractMetric(const DepthFrame& frame, PlaneSegmentation& result) {
  result.labels.resize(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height));
  if (measures_sensor_)
    measureSensor(frame, result.doubts);
  else
    sensor_ = given_sensor_;
  const DepthFrame view = scanView(frame, parameters_.scan);
  MetricPipeline& pipeline = workspace_->metric;
  pipeline.configure(parameters_, sensor_);
  StopWatch watch;
  pipeline.clusterLines(view);  // Algorithm 1
  times_.lines = watch.lap();
  pipeline.clusterPlanes();  // Algorithm 2
  times_.planes = watch.lap();
  const int count = pipeline.labelPixels(view, result.labels);
  workspace_->fitter.lendDepth(pipeline.depth(), pipeline.numberStride());
  times_.result = watch.lap();
  return count;
}

int PlaneExtractor::extractInverseDepth(const DepthFrame& frame, PlaneSegmentation& result) {
  StopWatch watch;
  InverseDepthPipeline& pipeline = workspace_->inverse_depth;
  pipeline.configure(parameters_, sensor_);
  const int stride = pipeline.gridStride(frame.width(), frame.height(), known_);
  workspace_->image.read(frame, parameters_.threads, stride);
  ScatteredPixels* const scattered = workspace_->scattered.find(workspace_->image) ? &workspace_->scattered : nullptr;
  const bool holds_together = scattered == nullptr || scattered->holdsTogether();
  if (scattered != nullptr) result.doubts.scattered_share = scattered->validShare();
  times_.read = watch.lap();
  adaptSensor(scattered == nullptr ? workspace_->image : scattered->measurable(workspace_->image),
              result.doubts);  // S0
  times_.sensor = watch.lap();
  pipeline.configure(parameters_, sensor_);
  const bool continues = known_ != nullptr && holds_together;
  if (!continues) pipeline.begin(workspace_->image, scattered);
  times_.read += watch.lap();
  if (continues) pipeline.beginKnown(workspace_->image, *known_, *continuation_);
  pipeline.growLines();  // S1
  times_.lines = watch.lap();
  pipeline.growPlanes();  // S2
  times_.planes = watch.lap();
  pipeline.joinDirections();    // S3
  pipeline.mergeRegions();      // S4
  pipeline.refineBoundaries();  // S5, S6
  pipeline.rejectClutter();     // S7
  pipeline.joinOccluded();      // S8
  pipeline.rejectThin();        // S9
  times_.regions = watch.lap();
  pipeline.labelPixels();
  moveLabels(frame, pipeline.labels(), result.labels);
  if (!frame.isTransposed() && pipeline.fitSamples().stride == stride)
    workspace_->fitter.lendSampleDepth(workspace_->image.sampleDepths());
  workspace_->fitter.lendCounts(pipeline.pixelCounts());
  workspace_->fitter.lendRows(frame.isTransposed() ? nullptr : pipeline.pixelRows());
  workspace_->fitter.lendConfidence(pipeline.confidence());
  times_.result = watch.lap();
  return pipeline.labelCount();
}

void PlaneExtractor::adaptSensor(const InverseDepthImage& image, Doubts& doubts) {
  sensor_ = given_sensor_;
  doubtDepths(image, doubts);
  if (!measures_sensor_ && !parameters_.inverse_depth.adapt_sensor) return;
  // Where nothing is looked for, a sensor that is known needs no measuring.
  const bool rests = known_ != nullptr && known_->may_wait && !known_->search && workspace_->estimator.isSettled();
  const SensorEstimate measured = rests ? workspace_->estimator.latest() : workspace_->estimator.update(image);
  sensor_ = measures_sensor_ ? measured.model() : adapted(given_sensor_, measured, image, workspace_->ratios);
  if (measures_sensor_ && measured.blocks > 0)
    workspace_->measured_error = ErrorCorrelation{{measured.blotch_share, measured.blotch_length}, {}};
  workspace_->measured_image = rests ? nullptr : &image;
  const bool may_be_generic = measures_sensor_ && measured.blocks == 0;
  doubts.sensor_is_generic = may_be_generic && workspace_->scattered.validShare() > 0.0;
  doubts.error_share = errorShare(image, measured, workspace_->ratios);
}

void PlaneExtractor::listSegments(const DepthFrame& frame, const ErrorCorrelation& error,
                                  PlaneSegmentation& result) const {
  SegmentFitter fitter(sensor_, error);
  if (parameters_.mode == Mode::Paper)
    workspace_->metric.listSegments(scanView(frame, parameters_.scan), result.labels, fitter, result.segments);
  else
    workspace_->inverse_depth.listSegments(frame, result.labels, fitter, result.segments);
  fitter.finish(result.segments.data());
}

// The paper mode has no use for the inverse depths but this.
void PlaneExtractor::measureSensor(const DepthFrame& frame, Doubts& doubts) {
  StopWatch watch;
  workspace_->image.read(frame, parameters_.threads);
  times_.read = watch.lap();
  ScatteredPixels& scattered = workspace_->scattered;
  const InverseDepthImage& measured = scattered.measuredForm(workspace_->image);
  if (&measured != &workspace_->image) doubts.scattered_share = scattered.validShare();
  adaptSensor(measured, doubts);
  times_.sensor = watch.lap();
}

bool PlaneExtractor::check(const DepthFrame& frame, PlaneSegmentation& result) {
  result.width = std::max(0, frame.width());
  result.height = std::max(0, frame.height());
  result.planes.clear();
  result.segments.clear();
  result.doubts = Doubts();
  times_ = StageTimes();
  status_ = Status::Ok;
  error_ = parameters_.validate();
  if (error_.empty()) error_ = vectorUnitProblem();
  if (error_.empty() && !measures_sensor_) error_ = given_sensor_.validate();
  if (!error_.empty()) return fail(Status::InvalidParameters, error_, result);
  if (frame.empty()) return fail(frame.status(), frame.problem(), result);
  const bool scans_rows = parameters_.scan == ScanDirection::Rows || frame.isTransposed();
  if (frame.projection() == Projection::Spherical && scans_rows)
    return fail(Status::UnsupportedScan, "the rows of a spherical scan are cones, not planar sections: scan by columns",
                result);
  return true;
}

bool PlaneExtractor::fail(Status status, const std::string& error, PlaneSegmentation& result) {
  status_ = status;
  error_ = error;
  result.planes.clear();
  result.segments.clear();
  if (status == Status::OutOfMemory || status == Status::Failed)
    result = PlaneSegmentation();  // takes no memory
  else
    result.labels.assign(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height), 0);
  return false;
}

}  // namespace epcc
