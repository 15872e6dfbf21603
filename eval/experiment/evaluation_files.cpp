// SPDX-License-Identifier: BSD-3-Clause
// Each file is named after its frame, in a folder that is made when the first of its kind is written.
#include "eval/experiment/evaluation_files.h"

#include <filesystem>

#include "datasets/files/label_image.h"
#include "datasets/files/png_io.h"
#include "datasets/support/output_folder.h"
#include "eval/pictures/mosaic.h"
#include "eval/pictures/overlay.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;

/// The path as a text, with its folder made.
std::string prepared(const fs::path& path) {
  makeOutputFolder(path.parent_path().string());
  return path.string();
}

/// What an interrupted attempt at the frame may have left.
void removeStale(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
}

}  // namespace

void writeLabelImages(const std::string& out, const FrameResult& result) {
  for (std::size_t m = 0; m < result.records.size(); ++m) {
    const fs::path path = fs::path(out) / "labels" / result.records[m].method / (result.file_name + "_labels.png");
    if (result.records[m].error.empty())
      writeLabelImage(prepared(path), result.segmentations[m]);
    else
      removeStale(path);
  }
}

void writeOverlays(const std::string& out, const FrameResult& result) {
  const fs::path path = fs::path(out) / "overlays" / (result.file_name + ".png");
  if (result.segmentations.empty()) return removeStale(path);
  Mosaic mosaic;
  mosaic.column_captions = {"depth", "truth"};
  mosaic.rows = {{shadeDepth(result.frame.depth), drawOverlay(result.frame.depth, result.frame.labels)}};
  for (std::size_t m = 0; m < result.segmentations.size(); ++m) {
    const bool done = result.records[m].error.empty();
    mosaic.column_captions.push_back(result.records[m].method);
    mosaic.rows[0].push_back(done ? drawOverlay(result.frame.depth, result.segmentations[m].labels) : ColorImage());
  }
  writeRgb(prepared(path), drawMosaic(mosaic));
}

}  // namespace epcc
