// SPDX-License-Identifier: BSD-3-Clause
// Where the frames of an experiment come from.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "datasets/labelled_frame.h"

namespace epcc {

/// A data set: frames by index, read on demand.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// Name in the reports.
  virtual const std::string& dataset() const = 0;
  virtual std::size_t size() const = 0;
  virtual std::string name(std::size_t index) const = 0;
  /// Reads or makes a frame, the same each time. Throws InputError. Several threads may call it at once.
  virtual LabelledFrame read(std::size_t index) const = 0;
};

/// A folder of native labelled frames, in the order of their names; the data set is named after the folder.
class NativeFolder : public FrameSource {
 public:
  /// Throws InputError for a folder that cannot be listed or has no frame.
  explicit NativeFolder(const std::string& folder);
  const std::string& dataset() const override { return dataset_; }
  std::size_t size() const override { return names_.size(); }
  std::string name(std::size_t index) const override { return names_.at(index); }
  LabelledFrame read(std::size_t index) const override;

 private:
  std::string folder_;
  std::string dataset_;
  std::vector<std::string> names_;
};

/// A folder of SynPEB scans, in the order of their names.
class SynpebFolder : public FrameSource {
 public:
  /// Throws InputError for a folder that cannot be listed or has no scan.
  explicit SynpebFolder(const std::string& folder);
  const std::string& dataset() const override { return dataset_; }
  std::size_t size() const override { return names_.size(); }
  std::string name(std::size_t index) const override { return names_.at(index); }
  LabelledFrame read(std::size_t index) const override;

 private:
  std::string folder_;
  std::string dataset_;
  std::vector<std::string> names_;
};

/// The last part of a folder's path, also for "frames/", "." and "..".
std::string folderName(const std::string& folder);

}  // namespace epcc
