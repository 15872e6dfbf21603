// SPDX-License-Identifier: BSD-3-Clause
// Frames, times and poses come together.
#include "eval/track/track_input.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "datasets/files/frame_pose.h"
#include "datasets/sources/dataset_registry.h"
#include "datasets/support/file_place.h"
#include "datasets/support/input_error.h"
#include "datasets/support/number_text.h"
#include "eval/program/frame_sensor.h"
#include "eval/track/earlier_run.h"

namespace epcc {

TrackInput::TrackInput(const TrackOptions& options) : options_(options), source_(openDataset(options.folder)) {
  const std::size_t frames = source_->size();
  if (options.first >= frames)
    throw InputError(
        options.folder, "frames",
        "there are " + std::to_string(frames) + ", none of them is --first " + std::to_string(options.first));
  count_ = (frames - options.first + options.every - 1) / options.every;
  if (options.count > 0) count_ = std::min(count_, options.count);
  if (!options.poses.empty()) poses_ = readTrajectory(options.poses);
}

std::vector<std::string> TrackInput::names() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count_; ++i) names.push_back(name(i));
  return names;
}

double TrackInput::timeOf(const LabelledFrame& frame, std::size_t index) const {
  const auto stamp = frame.camera.extra.find("timestamp");
  if (stamp != frame.camera.extra.end()) {
    if (!stamp->is_number() || !std::isfinite(stamp->get<double>()))
      throw InputError(frame.name + ".json", "timestamp", "is not a finite number");
    return stamp->get<double>();
  }
  const std::optional<double> named = numberFrom(frame.name);
  if (named && std::isfinite(*named) && frame.name.find('.') != std::string::npos) return *named;
  return static_cast<double>(index) / options_.rate;
}

SequenceFrame TrackInput::read(std::size_t i) const {
  SequenceFrame read;
  read.frame = source_->read(indexOf(i));
  if (!read.frame.scan.empty()) throw InputError(read.frame.name, "cloud", "is no depth image of a camera");
  readAs(read.frame, options_.reading);
  read.time = timeOf(read.frame, indexOf(i));
  read.pose = poses_.empty() ? framePose(read.frame) : poseAt(poses_, read.time, options_.max_time_difference);
  if (read.pose) read.pose->linear() = Eigen::Quaterniond(read.pose->linear()).normalized().toRotationMatrix();
  return read;
}

std::string outputProblem(const TrackOptions& options, const TrackInput& input) {
  namespace fs = std::filesystem;
  std::set<fs::path> folders;
  for (std::size_t i = 0; i < input.source().size(); ++i)
    for (const std::string& file : input.source().files(i)) folders.insert(fs::path(file).parent_path());
  for (const fs::path& folder : folders)
    if (filePlace(folder.empty() ? "." : folder.string()) == filePlace(options.out))
      return "--out: " + options.out + " holds the frames: labels beside them would be taken for their truth";
  for (const std::string& name : input.names()) {
    const std::string held = frameHeld(options.out, name);
    if (!held.empty())
      return "--out: " + options.out + " has " + held + ": labels beside it would be taken for its ground truth";
  }
  for (const std::string& file : filesOfRun(options.out)) {
    if (!options.poses.empty() && filePlace(file) == filePlace(options.poses))
      return "--out: " + file + " would overwrite the file of --poses";
    if (isNoiseFile(options.noise) && filePlace(file) == filePlace(options.noise))
      return "--out: " + file + " would overwrite the file of --noise";
  }
  const std::string foreign = foreignPicture(options.out, input.names());
  if (!foreign.empty())
    return "--out: " + options.out + " has " + foreign + ", which is of no frame of this run: choose another folder";
  return {};
}

}  // namespace epcc
