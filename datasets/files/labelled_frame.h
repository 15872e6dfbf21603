// SPDX-License-Identifier: BSD-3-Clause
// The native format: NAME_depth.png or the scan NAME.pcd, NAME_labels.png and NAME.json; a folder holds many.
#pragma once

#include <string>
#include <vector>

#include "datasets/files/camera_json.h"
#include "datasets/files/image.h"

namespace epcc {

/// A frame with its ground truth. `labels` is empty for an unlabelled frame.
struct LabelledFrame {
  std::string name;
  CameraFile camera;
  DepthImage depth;
  LabelImage labels;
  /// The file's values are smooth only once the two bytes of each are swapped, see bytesAreSwapped().
  bool bytes_are_swapped = false;
  /// x, y, z of every pixel of a cloud, as its file has them; `depth` holds the measured values (ranges of a scanner)
  /// in metres. Empty for a depth image, whose pixels `camera` turns into points.
  std::vector<float> scan;
  CloudOptions known;      ///< of `scan`, before its geometry was looked for
  CloudGeometry geometry;  ///< of `scan`
};

/// What a segmenter is given; the frame must outlive it.
DepthFrame frameView(const LabelledFrame& frame);

/// Names of the frames of a folder, numbers in numeric order: every NAME_depth.png, and every NAME.pcd that has a
/// NAME.json beside it. InputError if the folder cannot be listed.
std::vector<std::string> listLabelledFrames(const std::string& folder);
/// Path of what was measured, NAME_depth.png or NAME.pcd: where both exist, the depth image.
std::string labelledFrameFile(const std::string& folder, const std::string& name);
/// Name of the file in the folder that a NAME_labels.png beside it would be the ground truth of; empty if there is
/// none, or no such folder.
std::string frameHeld(const std::string& folder, const std::string& name);
/// Reads NAME's three files. InputError names the file whose size disagrees.
LabelledFrame readLabelledFrame(const std::string& folder, const std::string& name);
/// Depth is stored in units of camera.depth_scale, rounded; depths that do not fit 16 bits become invalid.
void writeLabelledFrame(const std::string& folder, const LabelledFrame& frame);

/// Raw depth units -> metres, by the frame's depth_scale; 0 where they are 0 or 65535, the last number there is.
void takeDepth(const Image<std::uint16_t>& raw, LabelledFrame& frame);

}  // namespace epcc
