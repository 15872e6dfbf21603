// SPDX-License-Identifier: BSD-3-Clause
// Read, track, write, sum up.
#include "eval/track/track_run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <new>
#include <ostream>
#include <set>

#include "datasets/support/atomic_file.h"
#include "datasets/support/input_error.h"
#include "datasets/support/quantile.h"
#include "eval/program/command_line.h"
#include "eval/program/frame_sensor.h"
#include "eval/program/lap_time.h"
#include "eval/program/progress_line.h"
#include "eval/report/table.h"
#include "eval/track/earlier_run.h"
#include "eval/track/track_files.h"
#include "eval/track/waiting_labels.h"

namespace epcc {
namespace {

const std::vector<std::string> kTimeColumns = {
    "frame",      "name",      "time_s",  "track_ms", "read_ms",  "sensor_ms", "lines_ms", "planes_ms",
    "regions_ms", "result_ms", "load_ms", "map_ms",   "write_ms", "planes",    "labels",   "open_directions"};

constexpr double kFarthestPose = 1e4;  // m from the start
constexpr double kHardlyBy = 16.27;    // squares of three parameters, 99.9 %
constexpr std::size_t kFewestSquares = 3;

bool isSomewhere(const Isometry3& pose) {
  return pose.matrix().allFinite() && pose.translation().norm() < kFarthestPose;
}

/// Nothing can be told of later frames.
class LostCamera : public InputError {
  using InputError::InputError;
};

class TrackRun {
 public:
  TrackRun(const TrackOptions& options, const TrackInput& input, std::ostream& times)
      : options_(options),
        input_(input),
        times_(times),
        map_(options.cell, options.parameters.inverse_depth.expert.refinement.crease_range) {
    times_ << csvLine(kTimeColumns);
  }

  void take(std::size_t i) {
    Clock::time_point start = Clock::now();
    const SequenceFrame read = input_.read(i);
    const double load_ms = lapMs(start);
    if (!result.trajectory.empty() && read.time <= result.trajectory.back().time)
      throw InputError(read.frame.name, "time", "is not later than that of the frame before");
    if (!tracker_ && !options_.poses.empty() && !options_.pose_free && !read.pose) {
      ++result.without_start;
      return;
    }
    if (!tracker_) start_with(read);
    start = Clock::now();
    std::optional<Isometry3> told;
    if (read.pose && (!options_.pose_free || result.names.empty())) told = Isometry3(*read.pose);
    const bool done = tracker_->track(frameView(read.frame), told, read.time, tracked_);
    if (tracker_->status() == Status::OutOfMemory) throw std::bad_alloc();  // the map may be lost
    if (!done) throw InputError(read.frame.name, "frame", tracker_->error());
    const double track_ms = lapMs(start);
    if (!isSomewhere(tracked_.pose.camera_to_map))
      throw LostCamera(read.frame.name, "pose",
                       "the camera was lost here; this frame and those behind it are left out");
    if (result.names.empty()) removeEarlierRun(options_.out, input_.names());
    map_.add(read.frame, tracked_, tracker_->sensor());
    const double map_ms = lapMs(start);
    writeLabels(read.frame);
    remember(read, i, track_ms, told);
    doubt(read.frame);
    const double write_ms = lapMs(start);
    writeTimes(read, track_ms, load_ms, map_ms, write_ms);
    if (result.measures) result.measures->add(read, tracked_, *tracker_);
  }

  void finish() {
    if (!tracker_) return;
    waiting_.writeAll(*tracker_);
    result.tracks = map_.tracks(tracker_->tracks());
    result.error_scale = tracker_->errorScale();
  }

  /// Writes what is known of frames whose labels wait.
  void rescue() noexcept { waiting_.rescue(); }

  TrackResult result;

 private:
  /// The sensor model that the first frame is given is that of all.
  void start_with(const SequenceFrame& read) {
    const FrameSensor sensor =
        frameSensor(options_.noise, read.frame.camera.noise, frameView(read.frame), read.frame.name + ".json");
    std::optional<SensorModel> model;
    if (!sensor.is_measured) model = sensor.model;
    result.sensor = sensor.is_measured ? "auto" : sensor.name;
    tracker_.emplace(options_.tracker, options_.parameters, model);
    if (options_.measure) result.measures = std::make_unique<TrackMeasures>(options_, model);
  }

  void writeLabels(const LabelledFrame& frame) {
    const std::string path = (std::filesystem::path(options_.out) / (frame.name + "_labels.png")).string();
    if (options_.online)
      writeLastingLabels(path, frame.depth.width, frame.depth.height, tracked_.labels);
    else
      waiting_.add(path, frame.depth.width, tracked_, *tracker_);
  }

  /// Half of the planes are where one of a thousand is by its covariance, or none is found again where nothing else
  /// tells where the camera is.
  bool isLost(const std::optional<Isometry3>& told) const {
    const std::vector<double>& squares = tracked_.squared_error;
    if (squares.empty()) return knows_planes_ && !told;
    return squares.size() >= kFewestSquares && median(squares) > kHardlyBy;
  }

  void remember(const SequenceFrame& read, std::size_t i, double track_ms, const std::optional<Isometry3>& told) {
    result.names.push_back(read.frame.name);
    result.places.push_back(i);
    if (tracked_.pose_jumped) result.jumps.push_back(read.frame.name);
    if (isLost(told)) result.lost.push_back(read.frame.name);
    knows_planes_ = knows_planes_ || !tracked_.segmentation.planes.empty();
    const std::vector<float>& depth = read.frame.depth.data;
    if (std::none_of(depth.begin(), depth.end(), [](float z) { return z > 0.0F; })) ++result.without_depth;
    result.open.push_back(static_cast<int>(openDirections(tracked_.pose_information).size()));
    result.trajectory.push_back({read.time, Eigen::Isometry3d(tracked_.pose.camera_to_map)});
    if (read.pose) result.truth.push_back({read.time, *read.pose});
    for (const double square : tracked_.squared_error) result.squared_errors.add(square);
    result.microseconds.add(std::lround(1e3 * track_ms));
  }

  void doubt(const LabelledFrame& frame) {
    Doubts doubts = tracked_.segmentation.doubts;
    doubts.bytes_are_swapped = frame.bytes_are_swapped;
    if (!doubts.any() || ++result.doubtful > 1) return;
    result.first_doubtful = frame.name;
    result.first_doubt = doubts.inWords();
  }

  void writeTimes(const SequenceFrame& read, double track_ms, double load_ms, double map_ms, double write_ms) {
    const StageTimes& stages = tracker_->times();
    std::set<std::int32_t> labels(tracked_.label_of_plane.begin(), tracked_.label_of_plane.end());
    labels.erase(0);
    std::vector<std::string> cells = {std::to_string(result.names.size() - 1), read.frame.name,
                                      numberCell(read.time, 6)};
    for (const double ms : {track_ms, 1e3 * stages.read, 1e3 * stages.sensor, 1e3 * stages.lines, 1e3 * stages.planes,
                            1e3 * stages.regions, 1e3 * stages.result, load_ms, map_ms, write_ms})
      cells.push_back(numberCell(ms, 3));
    cells.push_back(std::to_string(tracked_.segmentation.planes.size()));
    cells.push_back(std::to_string(labels.size()));
    cells.push_back(std::to_string(result.open.back()));
    times_ << csvLine(cells);
  }

  const TrackOptions& options_;
  const TrackInput& input_;
  std::ostream& times_;
  TrackMap map_;
  std::optional<PlaneTracker> tracker_;
  TrackedFrame tracked_;
  WaitingLabels waiting_;
  bool knows_planes_ = false;
};

void takeAll(TrackRun& run, const TrackInput& input, std::ostream& err) {
  ProgressLine progress(err);
  for (std::size_t i = 0; i < input.size(); ++i) {
    try {
      run.take(i);
    } catch (const LostCamera& error) {
      progress.clear();
      reportProblem("epcc_track", err, error.what(), kExitInput);
      ++run.result.problems;
      break;
    } catch (const InputError& error) {
      progress.clear();
      reportProblem("epcc_track", err, error.what(), kExitInput);
      ++run.result.problems;
    }
    progress.show(i + 1, input.size());
  }
}

}  // namespace

TrackResult runTracker(const TrackOptions& options, const TrackInput& input, std::ostream& err) {
  removeTemporaries(options.out, false);  // of runs that were killed
  TrackResult result;
  const std::string times = (std::filesystem::path(options.out) / "times.csv").string();
  writeAtomically(times, [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    TrackRun run(options, input, file);
    try {
      takeAll(run, input, err);
      run.finish();
    } catch (...) {  // memory that ran out, or what cannot be written
      run.rescue();
      throw;
    }
    file.close();
    if (!file) throw OutputError(times, "file", "cannot be written");
    result = std::move(run.result);
  });
  if (result.names.empty() && result.without_start > 0)
    throw InputError(options.poses, "poses", "none has the time of a frame (--max-time-difference, --pose-free)");
  if (result.names.empty()) throw InputError(options.folder, "frames", "none of them could be used");
  return result;
}

}  // namespace epcc
