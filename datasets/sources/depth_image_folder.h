// SPDX-License-Identifier: BSD-3-Clause
// What TUM, ICL-NUIM and ScanNet have in common: one camera, depth PNGs, and plane labels in a folder beside them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "datasets/sources/frame_source.h"

namespace epcc {

/// The parts of such a data set.
struct DepthImages {
  std::string folder;                    ///< of the data set
  std::vector<std::string> depth_files;  ///< relative to it
  /// Width and height 0: those of each depth image.
  CameraFile camera;
};

/// Paths of the PNGs in a folder of the data set, relative to it, in the order of the numbers in their names.
std::vector<std::string> depthImagesIn(const std::string& folder, const std::string& sub_folder);

/// The first of `candidates` that is a folder in `folder`, empty if none is.
std::string firstFolder(const std::string& folder, const std::vector<std::string>& candidates);

/// Labels are LABELS/STEM.png or LABELS/STEM.npy for a depth image STEM.png. Where the folder has labels, only the
/// depth images that have some are frames; else all are, unlabelled.
class DepthImageFolder : public FrameSource {
 public:
  /// `labels_folder` is relative to the data set's, empty for none. InputError if no depth image is left.
  DepthImageFolder(DepthImages images, const std::string& labels_folder);
  const std::string& dataset() const override { return dataset_; }
  std::size_t size() const override { return files_.size(); }
  std::string name(std::size_t index) const override;
  std::vector<std::string> files(std::size_t index) const override;
  LabelledFrame read(std::size_t index) const override;

 private:
  struct Files {
    std::string depth, labels;  // relative, labels may be empty
  };

  std::string folder_;
  std::string dataset_;
  CameraFile camera_;
  std::vector<Files> files_;
};

/// Labels of another program for an image of this size, by the file's ending: .npy, else PNG.
LabelImage readLabelFile(const std::string& path, int width, int height);

}  // namespace epcc
