// SPDX-License-Identifier: BSD-3-Clause
// A window of segmented frames slides over each sequence; the newest frame is compared with those at every lag.
#include "eval/experiment/sequence_repeatability.h"
#include "epcc_segmentation/sensor_estimation.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <utility>

#include "datasets/files/frame_pose.h"
#include "datasets/support/input_error.h"
#include "eval/program/frame_sensor.h"

namespace epcc {

namespace {

/// A frame of the window: what was seen, and each method's regions, or nothing where it failed.
struct SeenFrame {
  std::size_t index = 0;
  PosedView view;
  std::vector<std::optional<SeenRegions>> regions;
};

Eigen::Isometry3d poseOf(const LabelledFrame& frame) {
  if (!frame.scan.empty()) throw InputError(frame.name, "cloud", "is no depth image of a camera");
  const std::optional<Eigen::Isometry3d> pose = framePose(frame);
  if (!pose) throw InputError(frame.name + ".json", "pose", "is missing");
  return *pose;
}

class SequenceRun {
 public:
  SequenceRun(const std::vector<Method>& methods, const SequenceOptions& options)
      : methods_(methods), options_(options) {
    for (const Method& method : methods_) segmenters_.push_back(method.make());
    if (!options_.lags.empty())
      longest_ = static_cast<std::size_t>(*std::max_element(options_.lags.begin(), options_.lags.end()));
  }

  void take(const FrameJob& job) {
    if (job.source != source_) startSource(*job.source);
    while (!window_.empty() && job.index - window_.front().index > longest_) window_.pop_front();
    try {
      SeenFrame frame = seen(job);
      compareWithWindow(frame);
      window_.push_back(std::move(frame));
    } catch (const std::exception& error) {
      result_.problems.push_back(printable(error.what(), 1000));
    }
  }

  SequenceResult result() { return std::move(result_); }

 private:
  void startSource(const FrameSource& source) {
    source_ = &source;
    stream_.reset();
    window_.clear();
    first_row_ = result_.rows.size();
    for (const Method& method : methods_)
      for (const int lag : options_.lags) result_.rows.push_back({source.dataset(), method.name, lag, {}});
  }

  SeenFrame seen(const FrameJob& job) {
    LabelledFrame frame = job.source->read(job.index);
    readAs(frame, options_.reading);
    SeenFrame result;
    result.index = job.index;
    result.view.camera = frame.camera.camera;
    result.view.pose = poseOf(frame);
    const DepthFrame depth = frameView(frame);
    FrameSensor sensor = frameSensor(options_.noise, frame.camera.noise, depth, frame.name + ".json");
    if (sensor.is_measured) sensor.model = stream_.update(depth).model();  // a sequence is of one sensor
    result.view.depth = frame.depth;
    for (std::size_t m = 0; m < methods_.size(); ++m)
      result.regions.push_back(regionsOf(m, {depth, sensor.model, job.file_name, sensor.is_measured}, result.view));
    return result;
  }

  std::optional<SeenRegions> regionsOf(std::size_t m, const SegmenterInput& input, const PosedView& view) {
    if (!segmenters_[m]->segment(input, segmentation_)) {
      result_.problems.push_back(input.name + ": " + methods_[m].name + ": " +
                                 printable(segmenters_[m]->error(), 1000));
      return std::nullopt;
    }
    return seenRegions(view, segmentation_, input.sensor);
  }

  void compareWithWindow(const SeenFrame& later) {
    for (std::size_t l = 0; l < options_.lags.size(); ++l)
      for (const SeenFrame& earlier : window_)
        if (later.index - earlier.index == static_cast<std::size_t>(options_.lags[l])) compare(earlier, later, l);
  }

  void compare(const SeenFrame& earlier, const SeenFrame& later, std::size_t lag_index) {
    const std::vector<std::int32_t> shared = sharedPixels(earlier.view, later.view);
    const Eigen::Isometry3d later_from_earlier = later.view.pose.inverse() * earlier.view.pose;
    for (std::size_t m = 0; m < methods_.size(); ++m)
      if (earlier.regions[m] && later.regions[m])
        result_.rows[first_row_ + m * options_.lags.size() + lag_index].sums +=
            repeatability(shared, *earlier.regions[m], *later.regions[m], later_from_earlier);
  }

  const std::vector<Method>& methods_;
  const SequenceOptions& options_;
  std::vector<std::unique_ptr<PlaneSegmenter>> segmenters_;
  PlaneSegmentation segmentation_;
  const FrameSource* source_ = nullptr;
  SensorEstimator stream_;
  std::size_t longest_ = 0;
  std::size_t first_row_ = 0;  ///< of the source at hand
  std::deque<SeenFrame> window_;
  SequenceResult result_;
};

}  // namespace

SequenceResult measureSequences(const FrameJobs& jobs, const std::vector<Method>& methods,
                                const SequenceOptions& options, const SequenceProgress& progress) {
  SequenceRun run(methods, options);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    run.take(jobs[i]);
    if (progress) progress(i + 1, jobs.size());
  }
  return run.result();
}

}  // namespace epcc
