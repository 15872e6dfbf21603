// SPDX-License-Identifier: BSD-3-Clause
// Labels of 32 bits go into 16, of which 65535 means "not scored".
#include "datasets/files/label_image.h"

#include "datasets/files/image.h"
#include "datasets/files/png_io.h"
#include "datasets/support/input_error.h"

namespace epcc {

void writeLabelImage(const std::string& path, const PlaneSegmentation& segmentation) {
  if (segmentation.planes.size() >= kIgnoreLabel)
    throw OutputError(path, "labels", "more planes than a 16-bit image can hold");
  LabelImage image;
  image.width = segmentation.width;
  image.height = segmentation.height;
  image.data.assign(segmentation.labels.begin(), segmentation.labels.end());
  writeGray16(path, image);
}

}  // namespace epcc
