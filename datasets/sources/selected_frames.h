// SPDX-License-Identifier: BSD-3-Clause
// Some of a source's frames as a data set of their own.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "datasets/sources/frame_source.h"

namespace epcc {

/// The frames `indices` of another source, in this order and under another data set's name.
class SelectedFrames : public FrameSource {
 public:
  /// The original must outlive the selection.
  SelectedFrames(const FrameSource& original, std::string dataset, std::vector<std::size_t> indices)
      : original_(original), dataset_(std::move(dataset)), indices_(std::move(indices)) {}
  const std::string& dataset() const override { return dataset_; }
  std::size_t size() const override { return indices_.size(); }
  std::string name(std::size_t index) const override { return original_.name(indices_.at(index)); }
  std::vector<std::string> files(std::size_t index) const override { return original_.files(indices_.at(index)); }
  LabelledFrame read(std::size_t index) const override { return original_.read(indices_.at(index)); }

 private:
  const FrameSource& original_;
  std::string dataset_;
  std::vector<std::size_t> indices_;
};

}  // namespace epcc
