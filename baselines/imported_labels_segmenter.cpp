// SPDX-License-Identifier: BSD-3-Clause
// Reads label images.
#include "baselines/imported_labels_segmenter.h"

#include <algorithm>

#include "datasets/files/png_io.h"

namespace epcc {

bool ImportedLabelsSegmenter::run(const SegmenterInput& input, PlaneSegmentation& result) {
  if (input.name.empty()) return fail("the frame has no name to find its labels by");
  const std::string path = folder_ + "/" + input.name + "_labels.png";
  const LabelImage image = readGray16(path);
  // A transposed view keeps the caller's row-major arrays.
  const int width = input.frame.isTransposed() ? result.height : result.width;
  const int height = input.frame.isTransposed() ? result.width : result.height;
  if (image.width != width || image.height != height)
    return fail(path + ": " + std::to_string(image.width) + "x" + std::to_string(image.height) +
                " pixels, but the frame has " + std::to_string(width) + "x" + std::to_string(height));
  std::transform(image.data.begin(), image.data.end(), result.labels.begin(),
                 [](std::uint16_t label) { return label == kIgnoreLabel ? 0 : std::int32_t{label}; });
  fitLabels(input, *std::max_element(result.labels.begin(), result.labels.end()), result);
  return true;
}

}  // namespace epcc
