// SPDX-License-Identifier: BSD-3-Clause
// Copies of labelled frames on another grid: what a segmentation should not mind.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "datasets/sources/frame_source.h"

namespace epcc {

enum class FrameCopy {
  Mirrored,        ///< left and right change places
  Flipped,         ///< top and bottom do
  Turned,          ///< both do
  Transposed,      ///< rows become columns
  HalfResolution,  ///< every second pixel of every second row
  Holes            ///< a quarter of the pixels has no depth, at random, the same ones of all frames of a size
};

/// All of them.
std::vector<FrameCopy> frameCopies();
/// Whether it has the same pixels at other places.
bool hasSamePixels(FrameCopy copy);
/// "mirrored", "flipped", "turned", "transposed", "half", "holes".
std::string copyName(FrameCopy copy);

/// Depth, labels and camera of a camera's frame copied; std::invalid_argument for a spherical scan. At half the
/// resolution a sensor model's correlation length, which counts pixels, is halved, but for the form poly:K1,K2,K3 and
/// the preset d435i of that form. True planes and the pose belong to the original's axes and are
/// left out.
LabelledFrame copiedFrame(const LabelledFrame& frame, FrameCopy copy);

/// Copies of another source's frames, called DATASET-COPY.
class CopiedFrames : public FrameSource {
 public:
  /// The original must outlive the copies.
  CopiedFrames(const FrameSource& original, FrameCopy copy)
      : original_(original), copy_(copy), dataset_(original.dataset() + "-" + copyName(copy)) {}
  const std::string& dataset() const override { return dataset_; }
  std::size_t size() const override { return original_.size(); }
  std::string name(std::size_t index) const override { return original_.name(index); }
  LabelledFrame read(std::size_t index) const override { return copiedFrame(original_.read(index), copy_); }

 private:
  const FrameSource& original_;
  FrameCopy copy_;
  std::string dataset_;
};

}  // namespace epcc
