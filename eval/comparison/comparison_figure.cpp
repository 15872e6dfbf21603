// SPDX-License-Identifier: BSD-3-Clause
// Matches clusters with surfaces for their colours and sets the pictures side by side.
#include "eval/comparison/comparison_figure.h"

#include <algorithm>

#include "eval/pictures/mosaic.h"
#include "eval/pictures/overlay.h"

namespace epcc {

std::vector<std::int32_t> labelsAsInTruth(const LabelledFrame& frame, const PlaneSegmentation& segmentation) {
  const OverlapTable table = overlapTable(frame, segmentation);
  const std::size_t surfaces = table.surfaceCount() + 1;
  std::vector<std::size_t> largest(surfaces, 0);  // cluster of each surface, 0: none
  for (std::size_t c = 1; c <= table.clusterCount(); ++c) {
    const std::size_t g = table.dominant(c);
    if (g > 0 && (largest[g] == 0 || table.overlap(c, g) > table.overlap(largest[g], g))) largest[g] = c;
  }
  std::int32_t next = table.surfaceIds().back();
  std::vector<std::int32_t> renamed(segmentation.planes.size() + 1, -1);
  renamed[0] = 0;
  for (std::size_t c = 1; c <= table.clusterCount(); ++c) {
    const std::size_t g = table.dominant(c);
    const bool is_largest = g > 0 && largest[g] == c;
    renamed[static_cast<std::size_t>(table.clusterIds()[c])] = is_largest ? table.surfaceIds()[g] : ++next;
  }
  std::vector<std::int32_t> labels = segmentation.labels;
  for (std::int32_t& label : labels) {
    std::int32_t& name = renamed[static_cast<std::size_t>(label)];
    if (name < 0) name = ++next;  // a cluster that is not scored
    label = name;
  }
  return labels;
}

ColorImage drawAsInTruth(const LabelledFrame& frame, const PlaneSegmentation& segmentation) {
  OverlayStyle style;
  style.borders = false;  // ragged borders would hide the colours
  return drawOverlay(frame.depth, labelsAsInTruth(frame, segmentation), style);
}

ColorImage comparisonFigure(const Comparison& comparison, const std::string& epcc) {
  Mosaic mosaic;
  mosaic.column_captions = {"Depth (rendered)", "Ground truth", "RG", "RANSAC", "EPCC"};
  for (const ComparedFrame& compared : comparison.frames) {
    mosaic.row_captions.push_back(compared.scene);
    std::vector<ColorImage> row = {shadeDepth(compared.frame.depth),
                                   drawOverlay(compared.frame.depth, compared.frame.labels)};
    for (const std::string& method : {std::string("region-growing"), std::string("ransac"), epcc})
      row.push_back(drawAsInTruth(compared.frame, compared.segmentations.at(method)));
    mosaic.rows.push_back(row);
  }
  return drawMosaic(mosaic);
}

}  // namespace epcc
