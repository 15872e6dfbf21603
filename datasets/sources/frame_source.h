// SPDX-License-Identifier: BSD-3-Clause
// Where frames come from: the interface of all data sets.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "datasets/files/labelled_frame.h"

namespace epcc {

/// A data set: frames by index, read on demand.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// Name in the reports.
  virtual const std::string& dataset() const = 0;
  virtual std::size_t size() const = 0;
  virtual std::string name(std::size_t index) const = 0;
  /// Paths of the files that a frame is read from, its depth first; none if it is made.
  virtual std::vector<std::string> files(std::size_t /*index*/) const { return {}; }
  /// Reads or makes a frame, the same each time. Throws InputError. Several threads may call it at once.
  virtual LabelledFrame read(std::size_t index) const = 0;
};

}  // namespace epcc
