// SPDX-License-Identifier: BSD-3-Clause
// Names and writes the files of a frame.
#include "eval/experiment/evaluation_files.h"

#include <filesystem>

#include "datasets/files/png_io.h"
#include "datasets/support/input_error.h"
#include "eval/pictures/mosaic.h"
#include "eval/pictures/overlay.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;

/// The path as a text, with its folder made.
std::string prepared(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) throw OutputError(path.parent_path().string(), "folder", error.message());
  return path.string();
}

LabelImage labelImage(const PlaneSegmentation& segmentation, const std::string& path) {
  if (segmentation.planes.size() >= kIgnoreLabel)
    throw OutputError(path, "labels", "more planes than a 16-bit image can hold");
  LabelImage image(segmentation.width, segmentation.height);
  for (std::size_t i = 0; i < image.data.size(); ++i)
    image.data[i] = static_cast<std::uint16_t>(segmentation.labels[i]);
  return image;
}

}  // namespace

void writeLabelImages(const std::string& out, const FrameResult& result) {
  for (std::size_t m = 0; m < result.segmentations.size(); ++m) {
    if (!result.records[m].error.empty()) continue;
    const std::string path =
        prepared(fs::path(out) / "labels" / result.records[m].method / (result.file_name + "_labels.png"));
    writeGray16(path, labelImage(result.segmentations[m], path));
  }
}

void writeOverlays(const std::string& out, const FrameResult& result) {
  if (result.segmentations.empty()) return;
  Mosaic mosaic;
  mosaic.column_captions = {"depth", "truth"};
  mosaic.rows = {{shadeDepth(result.frame.depth), drawOverlay(result.frame.depth, result.frame.labels)}};
  for (std::size_t m = 0; m < result.segmentations.size(); ++m) {
    const bool done = result.records[m].error.empty();
    mosaic.column_captions.push_back(result.records[m].method);
    mosaic.rows[0].push_back(done ? drawOverlay(result.frame.depth, result.segmentations[m].labels) : ColorImage());
  }
  writeRgb(prepared(fs::path(out) / "overlays" / (result.file_name + ".png")), drawMosaic(mosaic));
}

}  // namespace epcc
