// SPDX-License-Identifier: BSD-3-Clause
// The frames of a sequence, each with its time and the camera's pose, if they are known.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "datasets/files/trajectory_file.h"
#include "datasets/sources/frame_source.h"
#include "eval/track/track_options.h"

namespace epcc {

/// A frame of the sequence.
struct SequenceFrame {
  LabelledFrame frame;
  double time = 0.0;                      ///< s
  std::optional<Eigen::Isometry3d> pose;  ///< camera to world, if it is known
};

/// The frames that the options choose, read one by one.
class TrackInput {
 public:
  /// Throws InputError: the data set or the trajectory cannot be used, or no frame is chosen.
  explicit TrackInput(const TrackOptions& options);

  std::size_t size() const { return count_; }
  std::string name(std::size_t i) const { return source_->name(indexOf(i)); }
  std::vector<std::string> names() const;
  const FrameSource& source() const { return *source_; }

  /// Reads one. The time is "timestamp" of its JSON, else its name, if that is a number with a point as in TUM's data
  /// sets, else its number divided by the rate. The pose is that of the trajectory at this time, if one was given, else
  /// the frame's own. InputError if the frame cannot be used or is no depth image of a camera.
  SequenceFrame read(std::size_t i) const;

 private:
  std::size_t indexOf(std::size_t i) const { return options_.first + i * options_.every; }
  double timeOf(const LabelledFrame& frame, std::size_t index) const;

  const TrackOptions& options_;
  std::unique_ptr<FrameSource> source_;
  std::size_t count_ = 0;
  Trajectory poses_;
};

/// Empty, or why the outputs would take the place of inputs, or stand beside those of another run.
std::string outputProblem(const TrackOptions& options, const TrackInput& input);

}  // namespace epcc
