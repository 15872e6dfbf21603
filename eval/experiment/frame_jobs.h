// SPDX-License-Identifier: BSD-3-Clause
// The frames of an experiment in a fixed order, and the part of them that is to be done.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "datasets/sources/frame_source.h"

namespace epcc {

/// One frame of a source, to be done by every method.
struct FrameJob {
  const FrameSource* source = nullptr;
  std::size_t index = 0;     ///< in the source
  std::size_t position = 0;  ///< among the frames of all sources
  /// Files of the frame are named after it: NAME, or DATASET/NAME where several sources have a frame NAME.
  std::string file_name;
};

/// Jobs are made on demand: a million frames cost their positions only.
class FrameJobs {
 public:
  std::size_t size() const { return positions_.size(); }
  FrameJob operator[](std::size_t i) const;
  /// Drops the jobs that are not wanted; those left keep position and name.
  void keepIf(const std::function<bool(const FrameJob&)>& wanted);
  void keepFirst(std::size_t count);

 private:
  friend FrameJobs listJobs(const std::vector<std::unique_ptr<FrameSource>>& sources);
  FrameJob at(std::size_t position) const;

  std::vector<const FrameSource*> sources_;
  std::vector<std::size_t> starts_;          ///< position of each source's first frame
  std::vector<std::uint64_t> shared_names_;  ///< hashes of the names that several sources use, sorted
  std::vector<std::size_t> positions_;       ///< of the jobs left, ascending
};

/// Every frame of every source in order; the sources must outlive the jobs.
FrameJobs listJobs(const std::vector<std::unique_ptr<FrameSource>>& sources);

}  // namespace epcc
